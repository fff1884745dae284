"use strict";

const Chart = {};

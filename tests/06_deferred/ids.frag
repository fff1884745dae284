// The number of the object that a pixel shows, counted from 1.
layout(location = 0) flat in uint object;
layout(location = 0) out uint id;

void main() { id = object; }

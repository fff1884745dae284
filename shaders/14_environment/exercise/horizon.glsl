// Exercise 14.horizon: how a depth along the search raises the horizon, or lowers it.
// Starter: nothing raises the horizon, and everything is open.

// [horizon]
// A slice is searched from a surface outwards, to one side, step by step. `horizon` is the
// cosine of the angle between the line of sight and the highest direction found so far: -1
// where there was none, 1 straight towards the camera. At this step a surface is found
// `away_m` metres away; the cosine of its direction is `found`.
//
// Distant surfaces hide less. With s = away_m / radius_m, at most 1, mix `found` with -1:
// found' = found + s^2 (-1 - found).
//
// Returns the new horizon. Where found' is above `horizon`, it is found'. Otherwise the
// search has come past what raised the horizon, which may be thin, with light behind it:
// move from `horizon` towards found' by the share `thickness` (0: not at all).
// [/horizon]
float raised_horizon(float horizon, float found, float away_m, float radius_m, float thickness) {
    return horizon;
}

// S. Hill's matrices, 2016; columns. Input: linear Rec. 709 through XYZ and D60 to ACES' AP1, and the RRT's desaturation.
// Output: the ODT's desaturation, and back.
const mat3 hill_input = mat3(0.59719, 0.07600, 0.02840, 0.35458, 0.90834, 0.13383, 0.04823, 0.01566, 0.83777);
const mat3 hill_output = mat3(1.60475, -0.10208, -0.00327, -0.53108, 1.10813, -0.07276, -0.07367, -0.00605, 1.07602);

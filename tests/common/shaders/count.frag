// Counts fragments: a pass without a target.
layout(scalar) buffer CountBuffer { uint count[]; };

void main() { atomicAdd(count[0], 1u); }

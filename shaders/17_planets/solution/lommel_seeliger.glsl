// Solution of 17.lommel_seeliger (H. von Seeliger, 1887). The sum is µ0 / (µ0 + µ), and 1/2 overhead.
float lommel_seeliger(float mu0, float mu) { return mu0 > 0.0 ? 2.0 * mu0 / (mu0 + max(mu, 0.0)) : 0.0; }

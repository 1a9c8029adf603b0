"""The terms of the energy (equation 1), unweighted, and `total`: their weighted sum and the oracle."""

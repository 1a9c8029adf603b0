"""How fast and how good the engine is: `python -m benchmarks [stages | davis]`. Nothing here is a test."""

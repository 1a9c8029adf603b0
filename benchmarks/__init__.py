"""How fast and how good the engine is: `python -m benchmarks [BENCHMARK]`. Nothing here is a test."""

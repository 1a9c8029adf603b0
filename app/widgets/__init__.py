"""The parts that forms and bars are made of."""

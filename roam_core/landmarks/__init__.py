"""Distinctive landmarks inside the object: detection, correlation filters, the pool that lives on, the star."""

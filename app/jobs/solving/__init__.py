"""What a run of the engine is while it is under way: what is known of it, and of what it is solved with."""

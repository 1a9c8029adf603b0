"""Review: pictures of a shot with its shapes for those who look at it: movies, contact sheets, lists of frames."""

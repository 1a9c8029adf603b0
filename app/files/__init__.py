"""Opening, saving, recent projects and recovered work: what lies between the project and its file."""

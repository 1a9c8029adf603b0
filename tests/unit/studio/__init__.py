"""Batches and farms: files of jobs, records, the run on a cluster, edits, jobs for farms."""

"""The scripts for other programs: Nuke's and Natron's against stand-ins, Blender's in Blender itself."""

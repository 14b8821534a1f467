package lightning.format.jen;

/**
 * File that a scene file names and the scene lacks, since it cannot be used.
 *
 * @param property property that names it
 * @param file its name in the scene file
 */
record LeftOutFile(String property, String file) {}

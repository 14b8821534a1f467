package lightning.cli.report;

import java.util.Map;

/**
 * A valid scene.
 *
 * @param objectsByType number of objects of each type that occurs
 * @param lightsByType  number of lights of each type that occurs
 * @param textures      number of texture files
 * @param gobos         number of gobo files
 */
public record CheckReport(String scene, long objects, Map<String, Long> objectsByType, long lights, Map<String, Long> lightsByType,
        long materials, long textures, long gobos, int widthPixels, int heightPixels, int depth) {}

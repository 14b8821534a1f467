package lightning.render.shading;

import lightning.render.gather.GatherStructure;

/**
 * Indirect light of a scene.
 *
 * @param structure its paths
 * @param light     light at each gather point: red, green, blue; in the units of the lights' diffuse sum
 * @param edgeLight the same as edge detection sees it; null without edge detection
 */
public record IndirectLight(GatherStructure structure, float[][] light, float[][] edgeLight) {
    // Arrays in a record: written once by their creator, never after.
}

package lightning.bench.result;

/**
 * Costs of editing a scene without a window.
 *
 * @param shapes        number of shapes
 * @param lights        number of lights
 * @param load          parsing the scene from text
 * @param tree          building primitives and their BVH
 * @param newScene      creating the scene of an edit from the previous one
 * @param plan          planning the update of an edited light
 * @param hover         first explanation of a pixel after a light moved
 * @param documentBytes heap bytes of the document per shape, without its text; NaN for few shapes
 * @param treeBytes     heap bytes of primitives and BVH per shape
 */
public record EditingCost(int shapes, int lights, TimeSamples load, TimeSamples tree, TimeSamples newScene, TimeSamples plan,
        TimeSamples hover,
        double documentBytes, double treeBytes) {}

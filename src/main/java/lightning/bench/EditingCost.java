package lightning.bench;

/**
 * What editing a scene costs below the editor's window.
 *
 * @param shapes        how many
 * @param lights        how many
 * @param load          reading the scene from its text
 * @param tree          making primitives and their tree of boxes
 * @param newScene      the scene of an edit, made of the one before
 * @param plan          planning an edit of a light
 * @param hover         the first explanation of a pixel after a light was moved
 * @param documentBytes bytes of heap for each shape that the document takes beside its text; NaN where there are few shapes
 * @param treeBytes     the same of primitives and tree
 */
public record EditingCost(int shapes, int lights, TimeSamples load, TimeSamples tree, TimeSamples newScene, TimeSamples plan,
        TimeSamples hover,
        double documentBytes, double treeBytes) {}

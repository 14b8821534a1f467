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
public record Editing(int shapes, int lights, Samples load, Samples tree, Samples newScene, Samples plan, Samples hover,
        double documentBytes, double treeBytes) {}

package lightning.format.mesh.subdivision;

/**
 * Quadrilaterals whose points are on the limit surface.
 *
 * @param points       numbers of each point, with the control mesh's stride
 * @param corners      four points of each quadrilateral
 * @param normals      unit normals, x, y, z each; zero where the surface has none
 * @param normalOf     normal of each corner
 * @param cornerValues numbers of each corner
 * @param origin       face of the control mesh that each quadrilateral is a part of
 */
public record RefinedMesh(double[] points, int[] corners, float[] normals, int[] normalOf, double[] cornerValues, int[] origin) {}

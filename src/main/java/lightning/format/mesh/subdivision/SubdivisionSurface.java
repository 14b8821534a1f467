package lightning.format.mesh.subdivision;

/** Refinement of control meshes. */
public final class SubdivisionSurface {
    private SubdivisionSurface() {}

    /**
     * Divides each face of {@code n} corners into {@code n · 4^(levels − 1)} quadrilaterals, and moves all points to the limit surface.
     *
     * @param cornerValues {@code cornerStride} numbers for each corner of the control mesh, such as texture coordinates; linear inside faces
     * @param levels at least 1
     */
    public static RefinedMesh refine(ControlMesh mesh, double[] cornerValues, int cornerStride, int levels) {
        PolygonTopology topology = mesh.topology;
        double[] points = mesh.points;
        double[] values = new double[cornerStride * mesh.inputCorners.length];
        for (int c = 0; c < mesh.inputCorners.length; c++) {
            System.arraycopy(cornerValues, cornerStride * mesh.inputCorners[c], values, cornerStride * c, cornerStride);
        }
        for (int level = 0; level < levels; level++) {
            points = CatmullClark.refine(topology, points, mesh.stride);
            values = CatmullClark.refineCorners(topology, values, cornerStride);
            topology = topology.refined();
        }
        LimitNormals.Result normals = LimitNormals.of(topology, points, mesh.stride);
        return new RefinedMesh(LimitSurface.project(topology, points, mesh.stride), topology.corners, normals.normals(),
                normals.normalOf(), values, topology.origin);
    }
}

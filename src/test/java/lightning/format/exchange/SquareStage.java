package lightning.format.exchange;

/** Start of a stage with a square of side 1 that has a material. */
final class SquareStage {
    private SquareStage() {}

    /**
     * Returns the text, without the material.
     *
     * @param material path of the material
     * @param repeats  copies of an image along each side
     */
    static String text(String material, int repeats) {
        return """
                #usda 1.0
                def Mesh "square" ( prepend apiSchemas = ["MaterialBindingAPI"] )
                {
                    uniform token subdivisionScheme = "none"
                    int[] faceVertexCounts = [4]
                    int[] faceVertexIndices = [0, 1, 2, 3]
                    point3f[] points = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]
                    texCoord2f[] primvars:st = [(0, 0), (N, 0), (N, N), (0, N)] ( interpolation = "vertex" )
                    rel material:binding = <PATH>
                }
                """.replace("N,", repeats + ",").replace("N)", repeats + ")").replace("PATH", material);
    }
}

package lightning.format.mesh.subdivision;

/** Numbers of points and corners at the next level. */
final class CatmullClark {
    private static final double CREASE_WEIGHT = 1 / 8.0;

    private CatmullClark() {}

    /** Returns the points of {@link PolygonTopology#refined()}. */
    static double[] refine(PolygonTopology t, double[] points, int stride) {
        int edges = t.edgeStart.length;
        double[] fine = new double[stride * (t.pointCount + edges + t.faceCount())];
        int firstEdge = stride * t.pointCount;
        int firstFace = firstEdge + stride * edges;
        for (int face = 0; face < t.faceCount(); face++) {
            int count = t.firstCorner[face + 1] - t.firstCorner[face];
            for (int i = 0; i < stride; i++) {
                double sum = 0;
                for (int c = t.firstCorner[face]; c < t.firstCorner[face + 1]; c++) {
                    sum += points[stride * t.corners[c] + i];
                }
                fine[firstFace + stride * face + i] = sum / count;
            }
        }
        double[] faceSums = new double[points.length];
        for (int c = 0; c < t.corners.length; c++) {
            for (int i = 0; i < stride; i++) {
                double middle = fine[firstFace + stride * t.faceOf[c] + i];
                fine[firstEdge + stride * t.edgeOf[c] + i] += middle;
                faceSums[stride * t.corners[c] + i] += middle;
            }
        }
        for (int edge = 0; edge < edges; edge++) {
            double sharpness = Math.min(1, t.edgeSharpness[edge]);
            for (int i = 0; i < stride; i++) {
                int at = firstEdge + stride * edge + i;
                double ends = points[stride * t.edgeStart[edge] + i] + points[stride * t.edgeEnd[edge] + i];
                fine[at] = sharpness == 1 ? ends / 2 : sharpness * (ends / 2) + (1 - sharpness) * ((ends + fine[at]) / 4);
            }
        }
        new PointRules(t, points, stride).apply(faceSums, CatmullClark::weight, CREASE_WEIGHT, fine);
        return fine;
    }

    private static double weight(int n, int kind) {
        return kind == 0 ? (n - 2.0) / n : 1 / ((double) n * n);
    }

    /** Returns the numbers of the next level's corners, linear between those of a face. */
    static double[] refineCorners(PolygonTopology t, double[] values, int stride) {
        double[] fine = new double[4 * values.length];
        for (int c = 0; c < t.corners.length; c++) {
            int first = t.firstCorner[t.faceOf[c]];
            int end = t.firstCorner[t.faceOf[c] + 1];
            for (int i = 0; i < stride; i++) {
                double sum = 0;
                for (int other = first; other < end; other++) {
                    sum += values[stride * other + i];
                }
                double own = values[stride * c + i];
                int at = 4 * stride * c + i;
                fine[at] = own;
                fine[at + stride] = (own + values[stride * t.next(c) + i]) / 2;
                fine[at + 2 * stride] = sum / (end - first);
                fine[at + 3 * stride] = (own + values[stride * t.previous(c) + i]) / 2;
            }
        }
        return fine;
    }
}

package lightning.format.mesh.subdivision;

/** Rules of the points of one level: smooth, crease or corner, or a mean of two if their sharpness ends at this level. */
final class PointRules {
    private static final int CREASE = 2;

    private final PolygonTopology topology;
    private final double[] points;
    private final int stride;
    /** Number of edges at each point. */
    private final int[] edges;
    private final double[] neighbors;
    private final SharpEdges sharp;
    /** Edges that are still sharp at the next level. */
    private final SharpEdges stillSharp;
    /** Sum of the sharpness that ends at this level, and the number of its edges and points. */
    private final float[] ending;
    private final int[] endings;

    PointRules(PolygonTopology topology, double[] points, int stride) {
        this.topology = topology;
        this.points = points;
        this.stride = stride;
        edges = new int[topology.pointCount];
        neighbors = new double[points.length];
        sharp = new SharpEdges(0);
        stillSharp = new SharpEdges(1);
        ending = new float[topology.pointCount];
        endings = new int[topology.pointCount];
        for (int edge = 0; edge < topology.edgeStart.length; edge++) {
            addEdge(edge, topology.edgeStart[edge], topology.edgeEnd[edge]);
            addEdge(edge, topology.edgeEnd[edge], topology.edgeStart[edge]);
        }
        for (int point = 0; point < topology.pointCount; point++) {
            addEnding(point, topology.pointSharpness[point]);
        }
    }

    private void addEdge(int edge, int point, int neighbor) {
        edges[point]++;
        add(neighbors, point, neighbor);
        sharp.add(edge, point, neighbor);
        stillSharp.add(edge, point, neighbor);
        addEnding(point, topology.edgeSharpness[edge]);
    }

    private void addEnding(int point, float sharpness) {
        if (sharpness > 0 && sharpness <= 1) {
            ending[point] += sharpness;
            endings[point]++;
        }
    }

    private void add(double[] sums, int point, int neighbor) {
        for (int i = 0; i < stride; i++) {
            sums[stride * point + i] += points[stride * neighbor + i];
        }
    }

    /** Edges above a sharpness at each point, and the sums of the points at their other ends. */
    private final class SharpEdges {
        private final float threshold;
        private final int[] count = new int[topology.pointCount];
        private final double[] sums = new double[points.length];

        SharpEdges(float threshold) {
            this.threshold = threshold;
        }

        void add(int edge, int point, int neighbor) {
            if (topology.edgeSharpness[edge] > threshold) {
                count[point]++;
                PointRules.this.add(sums, point, neighbor);
            }
        }

        /** Returns 0 or 1 for a smooth point, 2 for one of a crease, 3 for a corner. */
        int rule(int point) {
            return topology.pointSharpness[point] > threshold ? CREASE + 1 : Math.min(count[point], CREASE + 1);
        }
    }

    /** Weights of the smooth rule for a point of n edges: of itself, of each neighbor, and of each point across or in a face. */
    interface SmoothWeights {
        double weight(int n, int kind);
    }

    /**
     * Writes the new points.
     *
     * @param others for each point the sum of the points across its faces, or in them
     * @param creaseWeight weight of each neighbor along a crease
     */
    void apply(double[] others, SmoothWeights weights, double creaseWeight, double[] out) {
        for (int point = 0; point < topology.pointCount; point++) {
            int rule = sharp.rule(point);
            int nextRule = stillSharp.rule(point);
            boolean isMixed = Math.max(rule, 1) != Math.max(nextRule, 1) && endings[point] > 0;
            double share = isMixed ? Math.min(1, ending[point] / endings[point]) : 1;
            for (int i = stride * point; i < stride * (point + 1); i++) {
                double value = value(rule, sharp, point, i, others, weights, creaseWeight);
                out[i] = share == 1 ? value
                        : share * value + (1 - share) * value(nextRule, stillSharp, point, i, others, weights, creaseWeight);
            }
        }
    }

    private double value(int rule, SharpEdges creases, int point, int i, double[] others, SmoothWeights weights, double creaseWeight) {
        if (rule > CREASE || edges[point] == 0) {
            return points[i];
        }
        if (rule == CREASE) {
            return (1 - 2 * creaseWeight) * points[i] + creaseWeight * creases.sums[i];
        }
        int n = edges[point];
        return weights.weight(n, 0) * points[i] + weights.weight(n, 1) * neighbors[i] + weights.weight(n, 2) * others[i];
    }
}

package lightning.trace.primitive;

import lightning.math.Transform;

/** How far a placed solid may be met outside its box. */
final class Slack {
    private Slack() {}

    /**
     * How far a ray may meet the shape outside its box because {@code inverse} is rounded, scene units.
     *
     * <p>With E = map·inverse − 1 and r = map·(inverse of the origin) the solid that {@code inverse}
     * describes is the box's one moved by at most (|E|·reach + |r|) / (1 − |E|). Mapping a ray adds a few
     * roundings, made larger by |map|·|inverse|, the map's condition.
     *
     * @param reach the largest absolute coordinate of the shape's box
     * @return {@code +∞} where the condition is above 2²⁰: far from the shape roundings would outgrow any padding
     */
    static double of(Transform map, Transform inverse, double reach) {
        double[][] m = {{map.m00(), map.m01(), map.m02()}, {map.m10(), map.m11(), map.m12()}, {map.m20(), map.m21(), map.m22()}};
        double[][] i = {{inverse.m00(), inverse.m01(), inverse.m02(), inverse.t0()},
            {inverse.m10(), inverse.m11(), inverse.m12(), inverse.t1()}, {inverse.m20(), inverse.m21(), inverse.m22(), inverse.t2()}};
        double[] t = {map.t0(), map.t1(), map.t2()};
        double e = 0;
        double r = 0;
        double condition = 0;
        double magnitude = 0;
        for (int row = 0; row < 3; row++) {
            double rowError = 0;
            double rowCondition = 0;
            for (int column = 0; column < 3; column++) {
                double sum = row == column ? -1 : 0;
                for (int k = 0; k < 3; k++) {
                    sum += m[row][k] * i[k][column];
                    rowCondition += Math.abs(m[row][k] * i[k][column]);
                }
                rowError += Math.abs(sum);
            }
            double shift = t[row];
            double size = Math.abs(t[row]);
            for (int k = 0; k < 3; k++) {
                shift += m[row][k] * i[k][3];
                size += Math.abs(m[row][k] * i[k][3]);
            }
            e = Math.max(e, rowError);
            r = Math.max(r, Math.abs(shift));
            condition = Math.max(condition, rowCondition);
            magnitude = Math.max(magnitude, size);
        }
        double rounding = 0x1p-40 * (condition * reach + magnitude);
        e += 0x1p-40 * condition;
        return condition < 0x1p20 && e < 0.25 ? (e * reach + r) / (1 - e) + rounding : Double.POSITIVE_INFINITY;
    }
}

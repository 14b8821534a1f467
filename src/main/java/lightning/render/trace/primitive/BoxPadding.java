package lightning.render.trace.primitive;

import lightning.base.math.Transform;

/** How far a placed solid may be met outside its box. */
final class BoxPadding {
    private BoxPadding() {}

    /**
     * How far a ray may meet the shape outside its box because {@code inverse} is rounded, scene units.
     *
     * <p>With E = map·inverse − 1 and r = map·(inverse of the origin) the solid that {@code inverse}
     * describes is the box's one moved by at most (|E|·reach + |r|) / (1 − |E|). Mapping a ray adds a few
     * roundings, made larger by |map|·|inverse|, the map's condition.
     *
     * @param extent the largest absolute coordinate of the shape's box
     * @return {@code +∞} where the condition is above 2²⁰: far from the shape roundings would outgrow any padding
     */
    static double inverseErrorPadding(Transform map, Transform inverse, double extent) {
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
        double rounding = 0x1p-40 * (condition * extent + magnitude);
        e += 0x1p-40 * condition;
        return condition < 0x1p20 && e < 0.25 ? (e * extent + r) / (1 - e) + rounding : Double.POSITIVE_INFINITY;
    }

    /**
     * How far a ray may meet a canonical solid outside its box because its {@link lightning.render.trace.solid.SolidGeometry} rounds in own space, as a
     * share of the scene's extent.
     *
     * <p>What is met is met by the solid grown by 8 units in the last place of the farthest own coordinate of the ray's origin, up to
     * {@code edgeMarginFactor} times as far where its side leans ({@code HardRaysTest} holds it to 130 digits): 2⁻⁴⁹·tip·|o|. An origin within the
     * extent E has |o| ≤ √3·2·|inverse|·E, as the origin of own space is no farther than E either; |map| leads back to the scene. In
     * maximum norms, which know that a height lost in rounding is a width lost where the side is flat, and 2√3 ≤ 2².
     *
     * @param edgeMarginFactor as {@code Form} tells it
     */
    static double roundingShare(Transform map, Transform inverse, double edgeMarginFactor) {
        return 0x1p-47 * edgeMarginFactor * norm(map) * norm(inverse);
    }

    /** The greatest sum of a row of absolute values, without the translation. */
    private static double norm(Transform m) {
        Transform a = m.absolute();
        return Math.max(a.m00() + a.m01() + a.m02(), Math.max(a.m10() + a.m11() + a.m12(), a.m20() + a.m21() + a.m22()));
    }
}

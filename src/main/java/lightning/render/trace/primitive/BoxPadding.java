package lightning.render.trace.primitive;

import lightning.base.math.Transform;

/** Bounds on the distance outside a placed solid's box at which rays may still hit it. */
final class BoxPadding {
    private BoxPadding() {}

    /**
     * Returns the padding required because {@code inverse} is rounded, scene units.
     *
     * <p>With E = map·inverse − 1 and r = map·(inverse of the origin), the solid that {@code inverse} describes is the box's
     * one moved by at most (|E|·extent + |r|) / (1 − |E|). Mapping a ray adds a few roundings, amplified by |map|·|inverse|,
     * the map's condition.
     *
     * @param extent largest absolute coordinate of the shape's box
     * @return {@code +∞} if the condition is above 2²⁰: then rounding would exceed any padding for distant rays
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
     * Returns the padding required because {@link lightning.render.trace.solid.SolidGeometry} rounds in local space, relative
     * to the scene's extent.
     *
     * <p>Hits are exact for the solid extended by 8 ulp of the largest local coordinate of the ray's origin, times
     * {@code edgeMarginFactor} where its side leans: 2⁻⁴⁹·factor·|o| ({@code HardRaysTest} verifies this with 130 digits). An
     * origin within the extent E has |o| ≤ √3·2·|inverse|·E, since the local origin is within E too; |map| transforms back to
     * the scene. Maximum norms are used because a rounded height changes the width of a flat side; 2√3 ≤ 2².
     *
     * @param edgeMarginFactor value of the solid's {@code SolidGeometry}
     */
    static double roundingShare(Transform map, Transform inverse, double edgeMarginFactor) {
        return 0x1p-47 * edgeMarginFactor * norm(map) * norm(inverse);
    }

    /** Returns the maximum row sum of absolute values, without the translation. */
    private static double norm(Transform m) {
        Transform a = m.absolute();
        return Math.max(a.m00() + a.m01() + a.m02(), Math.max(a.m10() + a.m11() + a.m12(), a.m20() + a.m21() + a.m22()));
    }
}

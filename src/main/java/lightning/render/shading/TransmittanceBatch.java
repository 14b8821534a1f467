package lightning.render.shading;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import java.util.stream.IntStream;
import lightning.render.trace.Refraction;
import lightning.render.trace.ShadowRayBatch;
import lightning.render.trace.Tracer;
import lightning.render.trace.primitive.PrimitiveTable;
import lightning.render.trace.primitive.ShadowRayHits;
import lightning.scene.material.Material;
import lightning.scene.material.Transmission;

/**
 * Transmittance of many shadow rays, with the bits of {@link Transmittance}. The tracer computes the surfaces and the powers of all
 * hits together; only the products are formed one by one. Holds scratch memory: use one instance per thread.
 */
public final class TransmittanceBatch {
    private final PrimitiveTable primitives;
    private final Tracer tracer;
    /** Clear materials, by primitive; null until used. */
    private final ClearSurface[] surfaces;
    /** Exponents, later powers, of all paths inside, three channels each. */
    private double[] power = new double[64];
    private int powerCount;
    /** Red, green, blue of the latest ray, 0…1. */
    public final float[] rgb = new float[3];

    /**
     * @param thin    true for a pane, which has no inside
     * @param absorbs true if paths inside lose light; otherwise their transmittance is 1
     */
    private record ClearSurface(float[] reflective, float[] color, InteriorTint interior, boolean thin, boolean absorbs) {
        static ClearSurface of(Material material) {
            Transmission clarity = material.transmission();
            float[] reflective = new float[3];
            float[] color = new float[3];
            for (int c = 0; c < 3; c++) {
                reflective[c] = LightWeight.channel(material.reflective(), c);
                color[c] = LightWeight.channel(clarity.color(), c);
            }
            InteriorTint interior = new InteriorTint(clarity);
            boolean isTinted = IntStream.range(0, 3).anyMatch(c -> interior.log2(c) != 0);
            return new ClearSurface(reflective, color, interior, clarity.thin(), isTinted && !clarity.thin());
        }
    }

    public TransmittanceBatch(PrimitiveTable primitives, Tracer tracer) {
        this.primitives = primitives;
        this.tracer = tracer;
        surfaces = new ClearSurface[primitives.count];
    }

    private ClearSurface surface(int s) {
        ClearSurface known = surfaces[s];
        if (known == null) {
            known = ClearSurface.of(requireNonNull(primitives.shadowTint(s)));
            surfaces[s] = known;
        }
        return known;
    }

    /** Prepares all rays of a batch, whose hits are known. Call {@link #compute} next for each of the rays with a hit, in order. */
    public void begin(ShadowRayBatch rays, ShadowRayHits hits) {
        powerCount = 0;
        if (hits.count() == 0) {
            return;
        }
        tracer.writeHitSurfaces(rays, hits);
        for (int k = 0; k < rays.count; k++) {
            if (hits.first(k) != ShadowRayHits.END) {
                addExponents(rays, hits, k);
            }
        }
        tracer.exponentials(power, powerCount);
        powerCount = 0;
    }

    private static double length(ShadowRayBatch rays, int k) {
        return Math.sqrt(rays.dx[k] * rays.dx[k] + rays.dy[k] * rays.dy[k] + rays.dz[k] * rays.dz[k]);
    }

    private void addExponents(ShadowRayBatch rays, ShadowRayHits hits, int k) {
        double length = length(rays, k);
        double last = 0;
        ClearSurface entered = null;
        for (int i = hits.first(k); i != ShadowRayHits.END; i = hits.next(i)) {
            ClearSurface surface = surface(hits.primitive[i]);
            boolean isInside = hits.inside[i];
            if (isInside && surface.absorbs) {
                addExponents(surface.interior, (float) ((hits.t[i] - last) * length));
            }
            entered = isInside || surface.thin ? null : surface;
            last = hits.t[i];
        }
        if (rays.toPoints && entered != null && entered.absorbs) {
            addExponents(entered.interior, (float) ((1 - last) * length));
        }
    }

    private void addExponents(InteriorTint interior, float path) {
        if (powerCount + 3 > power.length - Tracer.EXPONENTIALS_OVERRUN) {
            power = Arrays.copyOf(power, 2 * power.length);
        }
        for (int c = 0; c < 3; c++) {
            power[powerCount++] = interior.exponent(c, path);
        }
    }

    /** Computes {@link #rgb} of a ray with a hit. */
    public void compute(ShadowRayBatch rays, ShadowRayHits hits, int k) {
        float red = 1;
        float green = 1;
        float blue = 1;
        ClearSurface entered = null;
        int p = powerCount;
        for (int i = hits.first(k); i != ShadowRayHits.END; i = hits.next(i)) {
            ClearSurface surface = surface(hits.primitive[i]);
            boolean isInside = hits.inside[i];
            float share = hits.reflectance[i];
            float[] kr = surface.reflective;
            float[] kt = surface.color;
            if (isInside && surface.absorbs) {
                red *= Refraction.transmitted(kr[0], share, kt[0]) * (float) power[p];
                green *= Refraction.transmitted(kr[1], share, kt[1]) * (float) power[p + 1];
                blue *= Refraction.transmitted(kr[2], share, kt[2]) * (float) power[p + 2];
                p += 3;
            } else {
                red *= Refraction.transmitted(kr[0], share, kt[0]);
                green *= Refraction.transmitted(kr[1], share, kt[1]);
                blue *= Refraction.transmitted(kr[2], share, kt[2]);
            }
            entered = isInside || surface.thin ? null : surface;
        }
        if (rays.toPoints && entered != null && entered.absorbs) {
            red *= (float) power[p];
            green *= (float) power[p + 1];
            blue *= (float) power[p + 2];
            p += 3;
        }
        powerCount = p;
        rgb[0] = red;
        rgb[1] = green;
        rgb[2] = blue;
    }
}

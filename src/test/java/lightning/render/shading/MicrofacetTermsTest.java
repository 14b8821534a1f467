package lightning.render.shading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.List;
import java.util.Random;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.sample.Slow;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.material.Material;
import lightning.scene.material.ShadingModel;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;

/**
 * Compares terms of metallic materials with the glTF 2.0 specification (appendix B.3) in high precision, and tests energy
 * conservation.
 */
class MicrofacetTermsTest {
    private static final MathContext DIGITS = new MathContext(60);
    /** Final rounding to float, plus the maximum error of the doubles before: N·H loses up to 2⁻⁵³/α² = 2⁻³⁵ of t, twice. */
    private static final double ROUNDING = 0x1p-24 + 0x1p-30;

    private static LightingEquation lit(Vec3 from) {
        Light light = Light.of("l", LightType.DIRECTIONAL).withDirection(from.times(-1));
        Scene scene = new Scene(PictureSettings.DEFAULT, new Camera(Vec3.ZERO, new Vec3(0, 0, -1), Vec3.Y, 40), World.DEFAULT, List.of(),
                List.of(),
                List.of(light));
        var equation = new LightingEquation(LightSource.of(light, scene));
        equation.moveTo(0, 0, 0, 0, 1, 0);
        return equation;
    }

    private static double alpha(double roughness) {
        return Material.of("m").withModel(ShadingModel.METALLIC).withRoughness(roughness).alpha();
    }

    private static BigDecimal exact(double v) {
        return new BigDecimal(v);
    }

    private static BigDecimal dot(double[] a, double[] b) {
        return exact(a[0]).multiply(exact(b[0])).add(exact(a[1]).multiply(exact(b[1]))).add(exact(a[2]).multiply(exact(b[2])));
    }

    /** Returns N·L·D·V by the specification without π, and s = (1 − V·H)⁵. */
    private static BigDecimal[] specification(double[] n, double[] l, double[] v, double alpha) {
        BigDecimal[] h = {exact(l[0]).subtract(exact(v[0])), exact(l[1]).subtract(exact(v[1])), exact(l[2]).subtract(exact(v[2]))};
        BigDecimal length = h[0].pow(2).add(h[1].pow(2)).add(h[2].pow(2)).sqrt(DIGITS);
        BigDecimal nh = exact(n[0]).multiply(h[0]).add(exact(n[1]).multiply(h[1])).add(exact(n[2]).multiply(h[2])).divide(length, DIGITS);
        BigDecimal vh =
                exact(v[0]).multiply(h[0]).add(exact(v[1]).multiply(h[1])).add(exact(v[2]).multiply(h[2])).negate().divide(length, DIGITS)
                        .divide(dot(v, v).sqrt(DIGITS), DIGITS);
        BigDecimal a2 = exact(alpha).pow(2);
        BigDecimal below = nh.pow(2).multiply(a2.subtract(BigDecimal.ONE)).add(BigDecimal.ONE).pow(2);
        BigDecimal nl = dot(n, l);
        BigDecimal visibility = smith(nl, a2).multiply(smith(dot(n, v).negate().max(BigDecimal.ZERO), a2));
        return new BigDecimal[] {nl.multiply(a2).divide(below, DIGITS).divide(visibility, DIGITS),
            BigDecimal.ONE.subtract(vh).pow(5)};
    }

    private static BigDecimal smith(BigDecimal cosine, BigDecimal a2) {
        return cosine.add(a2.add(BigDecimal.ONE.subtract(a2).multiply(cosine.pow(2))).sqrt(DIGITS));
    }

    /**
     * From smooth to rough, at normal and grazing angles, with the light at the ray's origin, in the mirror direction, and
     * everywhere else.
     */
    @Property
    void terms_matchSpecification(@ForAll long seed) {
        Random random = new Random(seed);
        double roughness = randomShare(random, 4);
        // A row level with the light is unlit, and H has no direction if the light is exactly opposite.
        double rise = Math.max(1e-12, randomShare(random, 12));
        double seen = random.nextInt(4) == 0 ? rise : randomShare(random, 12);
        double rotation = Math.PI * random.nextInt(3) + (random.nextInt(3) == 0 ? 6.3 : 1) * randomShare(random, 16);
        double side = Math.sqrt(1 - rise * rise);
        Vec3 to = new Vec3(side * Math.cos(rotation), rise, side * Math.sin(rotation)).normalized();
        float vx = (float) Math.sqrt(1 - seen * seen);
        float vy = (float) -seen;
        LightingEquation equation = lit(to);
        double alpha = alpha(roughness);
        // The light normalizes its direction, possibly with another rounding.
        Vec3 source = LightSource.of(Light.of("l", LightType.DIRECTIONAL).withDirection(to.times(-1)),
                new Scene(PictureSettings.DEFAULT, Camera.DEFAULT, World.DEFAULT, List.of(), List.of(), List.of())).position();
        BigDecimal[] expected = specification(new double[] {0, 1, 0}, new double[] {source.x(), source.y(), source.z()},
                new double[] {vx, vy, 0}, alpha);
        double gloss = expected[0].multiply(BigDecimal.ONE.subtract(expected[1])).doubleValue();
        double grazing = expected[0].multiply(expected[1]).doubleValue();
        // About 2⁻⁵² of 1 − V·H is lost, five times. At grazing angles the specular term is small compared with the grazing term,
        // to which it is added.
        double loss = expected[0].doubleValue() * 0x1p-45;
        assertThat((double) equation.metallicSpecular(0, 1, 0, vx, vy, 0, alpha)).isCloseTo(gloss, within(ROUNDING * gloss + loss + 1e-30));
        assertThat((double) equation.metallicGrazing(0, 1, 0, vx, vy, 0, alpha)).isCloseTo(grazing, within(ROUNDING * grazing + loss));
    }

    /** Returns a uniform share from 0 to 1, or one within a power of ten of either end, or the end itself. */
    private static double randomShare(Random random, double digits) {
        double small = random.nextInt(8) == 0 ? 0 : Math.pow(10, -digits * random.nextDouble());
        return switch (random.nextInt(3)) {
            case 0 -> random.nextDouble();
            case 1 -> small;
            default -> 1 - small;
        };
    }

    @Example
    void headOnHighlight_isQuarterOfInverseAlphaSquared() {
        for (double roughness : new double[] {0.25, 0.5, 1}) {
            double alpha = alpha(roughness);
            assertThat(lit(Vec3.Y).metallicSpecular(0, 1, 0, 0, -1, 0, alpha)).isEqualTo((float) (1 / (4 * alpha * alpha)));
            assertThat(lit(Vec3.Y).metallicGrazing(0, 1, 0, 0, -1, 0, alpha)).isZero();
        }
    }

    @Example
    void roughnessBelowMinimum_isClamped() {
        assertThat(alpha(0)).isEqualTo(alpha(Material.MIN_ROUGHNESS));
        assertThat(lit(Vec3.Y).metallicSpecular(0, 1, 0, 0, -1, 0, alpha(0))).isLessThan(6.1e7f).isPositive();
    }

    @Example
    void lightAlongViewRay_isNotNaN() {
        LightingEquation equation = lit(new Vec3(1, 0, 0));
        for (double roughness : new double[] {0, 0.5, 1}) {
            assertThat(equation.metallicSpecular(0, 1, 0, 1, 0, 0, alpha(roughness))).isZero();
            assertThat(equation.metallicGrazing(0, 1, 0, 1, 0, 0, alpha(roughness))).isNotNegative().isLessThan(6.1e7f);
        }
    }

    /** Reflectance towards the camera under uniform light from all directions, without base color and F0. */
    private record Albedo(double diffuse, double specular, double grazing) {
        double white(double f0) {
            return (1 - f0) * diffuse + f0 * specular + grazing;
        }

        /** Integrates over microfacet half-vectors distributed by D, which removes the peak from the sum. */
        static Albedo of(double roughness, double seen, int grid) {
            double a = alpha(roughness);
            float vx = (float) Math.sqrt(1 - seen * seen);
            float vy = (float) -seen;
            double specular = 0;
            double grazing = 0;
            double diffuse = 0;
            for (int i = 0; i < grid; i++) {
                double u = (i + 0.5) / grid;
                double c = Math.sqrt((1 - u) / (1 + (a * a - 1) * u));
                double s = Math.sqrt(1 - c * c);
                double d = a * a / Math.pow(c * c * (a * a - 1) + 1, 2);
                for (int j = 0; j < grid; j++) {
                    double rotation = (j + 0.5) / grid * Math.PI;
                    double vh = -(vx * s * Math.cos(rotation) + vy * c);
                    Vec3 to = new Vec3(2 * vh * s * Math.cos(rotation) + vx, 2 * vh * c + vy, 2 * vh * s * Math.sin(rotation));
                    if (vh > 0 && to.y() > 1e-9) {
                        LightingEquation equation = lit(to);
                        double weight = 4 * vh / (d * c);
                        specular += weight * equation.metallicSpecular(0, 1, 0, vx, vy, 0, a);
                        grazing += weight * equation.metallicGrazing(0, 1, 0, vx, vy, 0, a);
                    }
                    double cosine = Math.sqrt(u);
                    double side = Math.sqrt(1 - u);
                    LightingEquation equation = lit(new Vec3(side * Math.cos(rotation), cosine, side * Math.sin(rotation)));
                    diffuse += equation.metallicDiffuse(0, 1, 0, vx, vy, 0) / cosine;
                }
            }
            double all = (double) grid * grid;
            return new Albedo(diffuse / all, specular / all, grazing / all);
        }
    }

    /**
     * A white surface reflects at most the light it receives; the integration error is less than twice the difference from a
     * coarser grid.
     */
    @Property(tries = 60)
    @Slow
    void whiteSurface_conservesEnergy(@ForAll @DoubleRange(min = 0, max = 1) double roughness,
            @ForAll @DoubleRange(min = 0, max = 1) double seen, @ForAll @DoubleRange(min = 0, max = 1) double f0) {
        double fine = Albedo.of(roughness, seen, 160).white(f0);
        double coarse = Albedo.of(roughness, seen, 80).white(f0);
        assertThat(fine).isPositive().isLessThan(1 + 2 * Math.abs(fine - coarse) + 0x1p-20);
    }

    /** Factor that the material's constants leave to the equation. */
    @Example
    void baseColor_splitsIntoDiffuseAndF0() {
        Material half = Material.of("m").withModel(ShadingModel.METALLIC).withBase(new Rgb(1, 0.5, 0)).withMetalness(0.5).withF0(0.5);
        assertThat(half.albedo()).isEqualTo(new Rgb(1, 0.5, 0));
        assertThat(half.withModel(ShadingModel.PHONG).diffuse()).isEqualTo(half.base());
        assertThat(half.withModel(ShadingModel.PHONG).metalness()).isZero();
    }
}

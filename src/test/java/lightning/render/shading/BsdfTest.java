package lightning.render.shading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Map;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.render.trace.HitRows.ColumnGroup;
import lightning.render.trace.SurfacePoint;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.material.Anisotropy;
import lightning.scene.material.Coat;
import lightning.scene.material.Material;
import lightning.scene.material.ShadingModel;
import lightning.scene.material.Sheen;
import lightning.scene.material.Transmission;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;

/** Compares terms with another assembly of the same layers. A point faces up and is seen from above. */
class BsdfTest {
    private static final Material PRINCIPLED = Material.of("m").withModel(ShadingModel.PRINCIPLED);
    private static final HighlightFactor WHOLE = HighlightFactor.NONE;

    private static SurfacePoint point(Material material, double angle) {
        return new SurfacePoint(0, 0, 0, 0, 0, 0, 1, 0, (float) Math.sin(angle), (float) -Math.cos(angle), 0, new float[3], new float[3],
                material.roughness(), new float[] {1, 1, 1}, Map.of(ColumnGroup.TANGENT, new float[] {1, 0, 0}), null);
    }

    private static LightingEquation light(double angle, double turn) {
        Vec3 to = new Vec3(Math.sin(angle) * Math.cos(turn), Math.cos(angle), Math.sin(angle) * Math.sin(turn));
        Light light = Light.of("l", LightType.DIRECTIONAL).withDirection(to.times(-1));
        LightingEquation equation = new LightingEquation(LightSource.of(light,
                new Scene(PictureSettings.DEFAULT, Camera.DEFAULT, World.DEFAULT, List.of(), List.of(), List.of(light))));
        equation.moveTo(0, 0, 0, 0, 1, 0);
        return equation;
    }

    private static Bsdf.Terms terms(Material material, LightingEquation light, SurfacePoint at) {
        return Bsdf.of(material).terms(light, at, light.cosine(0, 1, 0), WHOLE);
    }

    @Provide
    Arbitrary<Material> layered() {
        Arbitrary<Double> unit = Arbitraries.doubles().between(0, 1);
        Arbitrary<Material> base = Combinators.combine(unit, unit, unit, unit).as((metalness, roughness, f0, strength) -> PRINCIPLED
                .withMetalness(metalness).withRoughness(roughness).withF0(f0).withAnisotropy(new Anisotropy(strength, 30)));
        Arbitrary<Coat> coats =
                Combinators.combine(unit, unit).as((weight, roughness) -> new Coat(weight < 0.3 ? 0 : weight, roughness, 1.5));
        Arbitrary<Sheen> sheens = Combinators.combine(unit, unit, unit)
                .as((red, green, roughness) -> new Sheen(red < 0.5 ? Rgb.BLACK : new Rgb(red, green, 0.2), roughness));
        return Combinators.combine(base, coats, sheens).as((m, coat, sheen) -> m.withCoat(coat).withSheen(sheen));
    }

    /** Facets, then the coat over them, then fibers over both. */
    @Property
    void principledTerms_areThoseOfItsLayers(@ForAll("layered") Material m, @ForAll @DoubleRange(min = 0, max = 1.5) double view,
            @ForAll @DoubleRange(min = 0, max = 1.5) double angle, @ForAll @DoubleRange(min = 0, max = 6) double turn) {
        SurfacePoint at = point(m, view);
        LightingEquation light = light(angle, turn);
        Bsdf.Principled bsdf = (Bsdf.Principled) Bsdf.of(m);
        double alpha = Material.alpha(m.roughness());
        double facets = m.isAnisotropic()
                ? light.anisotropicFacets(0, 1, 0, at.vx(), at.vy(), at.vz(), at.tangent(), AnisotropicHighlight.of(m), alpha)
                : light.facets(0, 1, 0, at.vx(), at.vy(), at.vz(), alpha);
        double schlick = light.schlick(at.vx(), at.vy(), at.vz());
        float specular = (float) (facets * (1 - schlick));
        float grazing = (float) (facets * schlick);
        if (m.coat().isVisible()) {
            PrincipledWeights weights = new PrincipledWeights();
            weights.moveTo(bsdf, at);
            double over = m.coat().alpha();
            grazing = weights.base() * grazing + (float) m.coat().weight()
                    * ((float) m.coat().f0() * light.metallicSpecular(0, 1, 0, at.vx(), at.vy(), at.vz(), over)
                            + light.metallicGrazing(0, 1, 0, at.vx(), at.vy(), at.vz(), over));
            specular *= weights.base();
        }
        Bsdf.Terms expected = !m.hasSheen() ? new Bsdf.Terms(light.cosine(0, 1, 0), specular, grazing)
                : new Bsdf.Terms(light.cosine(0, 1, 0), (float) m.f0UnderSheen() * specular + grazing,
                        light.sheen(0, 1, 0, at.vx(), at.vy(), at.vz(), m.sheen().roughness()));
        assertThat(terms(m, light, at)).isEqualTo(expected);
    }

    @Test
    void clearPrincipledMaterial_isShadedAsAMetallicOne() {
        Material glass = PRINCIPLED.withRoughness(0.02).withTransmission(Transmission.NONE.withColor(Rgb.WHITE).withIor(1.5));
        Bsdf bsdf = Bsdf.of(glass);
        assertThat(bsdf).isInstanceOf(Bsdf.Clear.class);
        assertThat(bsdf.surface()).isEqualTo(new Bsdf.Metal(glass.alpha()));
        assertThat(bsdf.hasFacets()).isTrue();
        assertThat(bsdf.losesDiffuse()).isTrue();
        LightingEquation light = light(0.5, 0);
        assertThat(terms(glass, light, point(glass, 0.3))).isEqualTo(bsdf.surface().terms(light, point(glass, 0.3), 1, WHOLE));
    }

    @Test
    void clearPhongMaterial_keepsItsHighlight() {
        Material glass = Material.of("m").withModel(ShadingModel.PHONG).withShininess(7)
                .withTransmission(Transmission.NONE.withColor(Rgb.WHITE));
        assertThat(Bsdf.of(glass).surface()).isEqualTo(new Bsdf.Phong(7));
        assertThat(Bsdf.of(glass).hasFacets()).isFalse();
    }

    @Test
    void frostedMaterial_isNotClear() {
        Material frosted = PRINCIPLED.withRoughness(0.5).withTransmission(Transmission.NONE.withColor(Rgb.WHITE).withIor(1.5));
        assertThat(Bsdf.of(frosted)).isInstanceOfSatisfying(Bsdf.Principled.class, bsdf -> assertThat(bsdf.isFrosted()).isTrue());
    }

    @Test
    void phongHighlight_isOneInTheMirroredDirection() {
        Material m = Material.of("m").withModel(ShadingModel.PHONG).withShininess(20);
        Bsdf.Terms terms = terms(m, light(0.4, 0), point(m, 0.4));
        assertThat(terms.specular()).isCloseTo(1, within(1e-5f));
        assertThat(terms.grazing()).isZero();
    }
}

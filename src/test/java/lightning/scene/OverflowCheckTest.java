package lightning.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.util.Set;
import lightning.document.LightEdits;
import lightning.document.MaterialEdits;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.sample.EditSession;
import lightning.scene.effects.RenderEffect;
import lightning.scene.effects.ViewEffects;
import lightning.scene.light.Light;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class OverflowCheckTest {
    private static final String BRIGHT = """
            camera { from 0 0 5 to 0 0 0 }
            material "wall" { specular 1 1 1 }
            sphere "ball" { material "wall" }
            light "sun" directional { intensity 1e30 color 1000 1 1 }
            """;
    private static final String GOLD = "material \"gold\" { model metallic roughness 0 }\n";

    private static Scene read(String text) throws JenException {
        return JenReader.read("jen 1\n" + text, "sun.jen", Path.of("")).scene();
    }

    @Test
    void oldFormatIntensity_isAccepted() throws JenException {
        assertThat(read(BRIGHT).light("sun").orElseThrow().weight().max()).isEqualTo(1e3 * 1e30);
    }

    @Test
    void roughMetal_allowsSameIntensity() throws JenException {
        assertThat(read(BRIGHT + GOLD.replace("roughness 0", "roughness 0.3")).material("gold")).isPresent();
    }

    @Test
    void smoothMetal_isReportedAtBrightestLight() {
        assertThatThrownBy(() -> read("light \"dim\" point { on no }\n" + BRIGHT + GOLD)).isInstanceOf(JenException.class)
                .hasMessageContaining("sun.jen:6:").hasMessageContaining("light 'sun': color times intensity of all lights must add up "
                        + "to at most 1.66e28 for metallic material 'gold', whose highlights are this sharp, was 1e33");
    }

    /** Its largest falloff depends on the surface, which the scene places. */
    @Test
    void lightOfObject_isReportedInItsPlace() {
        assertThatThrownBy(() -> read("light \"lamp\" object { shape ball intensity 1e30 color 1000 1 1 }\n"
                + BRIGHT.replace("1e30", "1") + GOLD)).isInstanceOf(JenException.class).hasMessageContaining("sun.jen:2:")
                .hasMessageContaining("light 'lamp': color times intensity");
    }

    @Test
    void tooBrightEdit_isRejected() throws JenException {
        Scene rough = read(BRIGHT + GOLD.replace("roughness 0", "roughness 0.3"));
        assertThat(MaterialEdits.edit(rough, "gold", m -> m.withRoughness(0)).refusal()).isPresent();
        Scene dim = rough.withLight(rough.light("sun").orElseThrow().withIntensity(1e20));
        Scene smooth = MaterialEdits.edit(dim, "gold", m -> m.withRoughness(0)).sceneOr(dim);
        assertThat(smooth).isNotEqualTo(dim);
        assertThat(LightEdits.edit(smooth, "sun", l -> l.withIntensity(1e30)).refusal()).isPresent();
    }

    /** Switching a light on, or removing its dimming group, must not exceed the limit. */
    @Test
    void darkLight_countsAsLit() throws JenException {
        String dark = BRIGHT.replace("1e30", "1e30 bank \"dim\" on no") + "bank \"dim\" { intensity 0 }\n";
        assertThat(read(dark).lights()).hasSize(1);
        assertThatThrownBy(() -> read(dark + GOLD)).isInstanceOf(JenException.class);
    }

    /** An effect that the view hides must not exceed the limit: a gain or a group. */
    @ParameterizedTest
    @ValueSource(strings = {"intensity 1e29 diffuse 0 specular 0", "intensity 1e29 bank \"dim\"",
        "intensity 1e29 diffuse 0 specular 0 bank \"dim\""})
    void effectThatDims_countsAsAbsent(String light) throws JenException {
        String dim = "camera { from 0 0 5 to 0 0 0 }\nsphere \"ball\" { }\nbank \"dim\" { intensity 0 }\n"
                + "light \"lamp\" point { " + light + " }\n";
        assertThat(read(dim).lights()).hasSize(1);
        assertThatThrownBy(() -> read(dim + GOLD)).isInstanceOf(JenException.class).hasMessageContaining("must add up");
    }

    /** The size of a light limits its falloff, also in a view without soft shadows. */
    @Test
    void sizeOfLight_countsAlways() throws JenException {
        String scene = "camera { from 0 0 5 to 0 0 0 }\nsphere \"ball\" { }\n" + GOLD;
        String lamp = "light \"lamp\" point { intensity 1e20 falloff inverse_square radius 100 }\n";
        assertThat(ViewEffects.ALL.withHidden(Set.of(RenderEffect.SOFT_SHADOWS)).apply(read(scene + lamp)).lights())
                .noneMatch(Light::isArea);
        assertThatThrownBy(() -> read(scene + lamp.replace("radius 100", ""))).hasMessageContaining("must add up");
    }

    @Property(edgeCases = EdgeCasesMode.NONE)
    void sceneWithoutEffects_isValid(@ForAll("sessions") EditSession session) {
        for (Scene scene : session.scenes()) {
            for (RenderEffect effect : RenderEffect.ALL) {
                assertThatCode(() -> ViewEffects.ALL.withHidden(Set.of(effect)).apply(scene)).as(effect.title()).doesNotThrowAnyException();
            }
        }
    }

    @Provide
    Arbitrary<EditSession> sessions() {
        return Arbitraries.oneOf(EditSession.mixedSessions(), EditSession.extremeSessions());
    }
}

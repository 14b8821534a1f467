package lightning.scene;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import lightning.format.jen.JenReader;
import org.junit.jupiter.api.Test;

class SceneWarningsTest {
    private static final String BALL = "material glowing { ambient 0.1 0 0 }\nsphere ball { material glowing }\n";

    private static List<String> warnings(String text) throws Exception {
        return SceneWarnings.of(JenReader.read("jen 1\n" + text, "test", Path.of("")).scene());
    }

    @Test
    void indirectLightAndAmbience_countTwice() throws Exception {
        assertThat(warnings(BALL + "picture { indirect {} }"))
                .containsExactly("ambience and indirect light count twice: set ambience to 0");
    }

    @Test
    void oneOfBoth_isNoWarning() throws Exception {
        assertThat(warnings(BALL)).isEmpty();
        assertThat(warnings(BALL + "picture { indirect {} }\nworld { ambience 0 }")).isEmpty();
    }

    @Test
    void ambienceWithoutAmbientColors_isNoWarning() throws Exception {
        assertThat(warnings("material glowing { ambient 0.1 0 0 }\nsphere ball {}\npicture { indirect {} }")).isEmpty();
    }

    @Test
    void openLensWithoutAntialiasing_hasNoEffect() throws Exception {
        assertThat(warnings("camera { aperture 0.1 }"))
                .containsExactly("the aperture of the camera has no effect: anti-aliasing is off");
        assertThat(warnings("camera { aperture 0.1 }\npicture { antialias edges }")).isEmpty();
    }

    @Test
    void lightWithoutObject_isDark() throws Exception {
        assertThat(warnings("light lamp object {}")).containsExactly("light lamp is dark: it has no object that shines");
        assertThat(warnings("group g {} light lamp object { shape g }")).hasSize(1);
    }

    /** The glow of a surface lights others only indirectly, and its light does so directly. */
    @Test
    void glowingObjectThatIsALight_countsTwiceWithIndirectLight() throws Exception {
        String scene = "material neon { glow 3 3 3 } sphere sign { material neon } light lamp object { shape sign }";
        assertThat(warnings(scene)).isEmpty();
        assertThat(warnings("picture { indirect { } } world { ambience 0 } " + scene)).singleElement().asString().contains("sign", "neon",
                "twice");
    }
}

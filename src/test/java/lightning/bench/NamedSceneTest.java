package lightning.bench;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import lightning.scene.AntialiasMode;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import org.junit.jupiter.api.Test;

class NamedSceneTest {
    /** A command line rejects an option that appears twice. */
    @Test
    void repeatedChangesOfAntialiasing_areOneOption() {
        Scene plain = GeneratedScenes.of(1, new PictureSize(8, 6), 3, 1, 1);
        Scene sampled = plain.withPicture(plain.picture().withSampling(new SamplingSettings(AntialiasMode.EVERY, 3)));
        NamedScene named = new NamedScene("sampled", sampled, Path.of("sampled.jen")).withoutAntialiasing()
                .withSampling(new SamplingSettings(AntialiasMode.EDGES, 4));
        assertThat(named.renderOptions()).containsExactly("--antialias", "edges", "--samples", "4");
    }
}

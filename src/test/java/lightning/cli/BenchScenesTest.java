package lightning.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import lightning.bench.NamedScene;
import lightning.scene.AntialiasMode;
import lightning.scene.SamplingSettings;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class BenchScenesTest {
    @TempDir
    private Path folder;

    private NamedScene write(String name, String mode) throws Exception {
        Path file =
                Files.writeString(folder.resolve(name + ".jen"), "jen 1\npicture { antialias " + mode + "  samples 3 }\nsphere ball {}\n");
        return BenchScenes.read(List.of(file), List.of()).scenes().getFirst();
    }

    @Test
    void antialiasing_isLeftOutOfScenesThatAreNotNamed() throws Exception {
        BenchScenes scenes = new BenchScenes(List.of(write("rough", "edges"), write("kept", "edges")), List.of());

        List<NamedScene> measured = scenes.withoutAntialiasing(List.of("kept")).scenes();

        assertThat(measured).extracting(scene -> scene.scene().picture().sampling().antialias())
                .containsExactly(AntialiasMode.OFF, AntialiasMode.EDGES);
    }

    /** Cold processes read the file again. */
    @Test
    void leftOutAntialiasing_isAnOptionOfItsProcess() throws Exception {
        assertThat(write("rough", "every").withoutAntialiasing().renderOptions()).containsExactly("--antialias", "off", "--samples",
                Integer.toString(SamplingSettings.DEFAULT.grid()));
    }

    @Test
    void sceneWithoutAntialiasing_staysAsItIs() throws Exception {
        NamedScene plain = write("plain", "off");

        assertThat(plain.withoutAntialiasing()).isSameAs(plain);
    }
}

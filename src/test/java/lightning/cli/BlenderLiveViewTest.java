package lightning.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import lightning.sample.PythonPrograms;
import lightning.sample.Slow;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** The live view of the Blender add-on in Blender itself. */
@Slow
@DisabledOnOs(OS.WINDOWS)
class BlenderLiveViewTest {
    @TempDir
    private Path folder;

    @Test
    void pictures_equalSceneSentAnew() throws Exception {
        PythonPrograms.require("bpy");
        BlenderAddOn.install(folder);
        String script = Path.of("src/test/python/blender_live_view.py").toAbsolutePath().toString();
        assertThat(PythonPrograms.output(folder, List.of("-B", script, folder.toString()))).contains("all pictures are equal");
    }
}

package lightning.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import lightning.sample.Nightly;
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

    private void edit(String size) throws Exception {
        PythonPrograms.require("bpy");
        assertThat(Blender.run(folder, "blender_live_view.py", size)).contains("all pictures are equal");
    }

    @Test
    void pictures_equalSceneSentAnew() throws Exception {
        edit("small");
    }

    /**
     * With reflections during all edits, and a server of its own for the scenes that are sent again; {@link #pictures_equalSceneSentAnew} has
     * reflections only where they are edited.
     */
    @Test
    @Nightly
    void largePictures_equalSceneSentAnew() throws Exception {
        edit("large");
    }
}

package lightning.format.jen;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import lightning.render.trace.Geometry;
import lightning.scene.Scene;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A scene that is read again, such as by a resident process or after an edit of its file. */
class RepeatedMeshTest {
    private static final String TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 %s 0\nf 1 2 3\n";

    @TempDir
    private Path folder;

    private Scene read(String height) throws Exception {
        Files.writeString(folder.resolve("a.obj"), TRIANGLE.replace("%s", height));
        String text =
                "jen 1\nmaterial red { diffuse 1 0 0 }\nmesh a { material red  file \"a.obj\" }\nsphere b { material red  at 0 %s 0 }\n";
        return JenReader.read(text.replace("%s", height.equals("1") ? "2" : "3"), "a.jen", folder).scene();
    }

    private static boolean[] kept(Scene before, Scene after) {
        int[] mapped = Geometry.of(before).changeTo(after).mapIndices(new int[] {0, 1});
        return new boolean[] {mapped[0] >= 0, mapped[1] >= 0};
    }

    @Test
    void meshOfAnEditedScene_staysUnchanged() throws Exception {
        Scene before = read("1");
        Files.writeString(folder.resolve("a.obj"), TRIANGLE.replace("%s", "1.0"));
        Scene after = JenReader.read("jen 1\nmaterial red { diffuse 1 0 0 }\nmesh a { material red  file \"a.obj\" }\n"
                + "sphere b { material red  at 0 5 0 }\n", "a.jen", folder).scene();
        assertThat(kept(before, after)).containsExactly(true, false);
    }

    @Test
    void editedMesh_isChanged() throws Exception {
        assertThat(kept(read("1"), read("1.5"))).containsExactly(false, false);
    }
}

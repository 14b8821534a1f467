package lightning.layer;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import lightning.base.math.Vec3;
import lightning.format.jen.JenDocument;
import lightning.format.jen.JenReader;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Neighbors of a frame in its shot. */
class ShotFrameTest {
    @TempDir
    private Path folder;

    private ShotFrame frame(String from, int frame) throws Exception {
        Path file = Files.writeString(folder.resolve("a.jen"), """
                jen 1
                camera { from 0 0 9  to 0 0 0 }
                shot { frames 2 3  rate 30  camera { from { %s } } }
                """.replace("%s", from));
        JenDocument document = JenReader.read(file);
        return ShotFrame.of(document.shot().orElseThrow(), document.scene(), frame);
    }

    /** Keyframes reach beyond the frames of the shot. */
    @Test
    void neighbors_areOneFrameAway() throws Exception {
        ShotFrame first = frame("1 0 0 1  2 0 0 3  3 0 0 5  4 0 0 7", 2);
        assertThat(first.time()).isEqualTo(new FrameTime(2, 30));
        assertThat(first.previous().camera().from()).isEqualTo(new Vec3(0, 0, 1));
        assertThat(first.next().camera().from()).isEqualTo(new Vec3(0, 0, 5));
    }

    @Test
    void nothingMoves_beforeTheFirstKeyframe() throws Exception {
        assertThat(frame("2 0 0 1  4 0 0 7", 2).previous().camera().from()).isEqualTo(new Vec3(0, 0, 1));
    }

    /** At frame 4 the camera is at its target. */
    @Test
    void invalidNeighbor_countsAsStill() throws Exception {
        assertThat(frame("1 0 0 3  4 0 0 0", 3).next().camera().from()).isEqualTo(new Vec3(0, 0, 1));
    }
}

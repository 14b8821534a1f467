package lightning.document.motion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIOException;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import lightning.base.math.Vec3;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.shot.KeyframeValue;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class MotionPathFileTest {
    private static final Light LIGHT = Light.of("key", LightType.SPOT);

    @TempDir
    private Path folder;

    @Provide
    Arbitrary<RecordedShot> paths() {
        Arbitrary<Double> coordinate = Arbitraries.doubles().between(-1e6, 1e6);
        Arbitrary<Vec3> points = Combinators.combine(coordinate, coordinate, coordinate).as(Vec3::new);
        Arbitrary<Light> keys = Combinators.combine(points, points.filter(v -> v.maxAbs() > 1e-6))
                .as((at, to) -> LIGHT.withPosition(at).withDirection(to));
        return Combinators.combine(Arbitraries.integers().between(1, 10000), keys.list().ofMinSize(1).ofMaxSize(20))
                .as(RecordedShot::of);
    }

    private static Light key(double x) {
        return LIGHT.withPosition(new Vec3(x, 0, 0)).withDirection(new Vec3(0, -1, 0));
    }

    @Test
    @DisabledOnOs(OS.WINDOWS)
    void pipe_isRejectedImmediately() throws Exception {
        Path pipe = folder.resolve("pipe.path");
        assertThat(new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor()).isZero();
        assertThatIOException().isThrownBy(() -> MotionPathFile.load(pipe, "key"))
                .withMessageContaining("pipe.path: is a pipe or a device");
    }

    @Property
    void path_roundTrips(@ForAll("paths") RecordedShot path) throws IOException {
        assertThat(MotionPathFile.read(MotionPathFile.write(path), "a.path", "key")).isEqualTo(path);
    }

    @Test
    void savedFile_canBeLoaded() throws IOException {
        RecordedShot path = RecordedShot.of(7, List.of(key(-0.0), key(1e-300)));
        MotionPathFile.save(path, folder.resolve("a.path"));
        assertThat(MotionPathFile.load(folder.resolve("a.path"), "key")).isEqualTo(path);
    }

    @Test
    void documentedExample_isRead() throws IOException {
        String page = Files.readString(Path.of("docs/motion-path.md"));
        var example = Pattern.compile("```path\n(.*?)```", Pattern.DOTALL).matcher(page);
        assertThat(example.find()).isTrue();
        RecordedShot path = MotionPathFile.read(example.group(1), "docs/motion-path.md", "key");
        assertThat(path.interval()).isEqualTo(10);
        assertThat(path.frameCount()).isEqualTo(21);
        assertThat(path.shot().tracks().stream().map(t -> t.keys().getFirst().value()))
                .containsExactly(new KeyframeValue.Numbers(List.of(-2.3, 3.6, 2.6)), new KeyframeValue.Numbers(List.of(0.0, -1.0, 0.0)));
        assertThat(page).contains("1 to " + RecordedShot.MAX_INTERVAL, "1 to " + RecordedShot.MAX_KEYS);
        assertThatIOException().isThrownBy(() -> MotionPathFile.read("lightning-path 1\n\nat high", "sunset.path", "key"))
                .withMessageStartingWith("sunset.path:3: expected ");
    }

    @Test
    void missingInterval_isTen() throws IOException {
        assertThat(MotionPathFile.read("lightning-path 1\nat 0 0 0 direction 0 -1 0", "a", "key").interval()).isEqualTo(10);
    }

    @Test
    void invalidText_isRejectedWithLocationAndReason() {
        assertRejected("", "a.path: expected lightning-path 1, found 'nothing'");
        assertRejected("jen 1", "a.path:1: expected lightning-path 1, found 'jen 1'");
        assertRejected("lightning-path 1", "a.path: expected at least one key, as in 'at 0 3 2  direction 0 -1 0', found 'none'");
        assertRejected("lightning-path 1\nevery 0", "a.path:2: expected a whole number from 1 to 10000, found '0'");
        assertRejected("lightning-path 1\nevery 1.5", "a.path:2: expected a whole number from 1 to 10000, found '1.5'");
        assertRejected("lightning-path 1\nevery", "a.path:2: expected every and a whole number, found 'every'");
        assertRejected("lightning-path 1\nat 0 high 0 direction 0 -1 0", "a.path:2: expected a number, found 'high'");
        assertRejected("lightning-path 1\nat 0 0 0", "a.path:2: expected at x y z direction x y z, found 'at 0 0 0'");
        assertRejected("lightning-path 1\nat 0 0 0 direction 0 0 0", "a.path:2: direction must not be zero, was 0 0 0");
        assertThatIOException().isThrownBy(() -> MotionPathFile.read("lightning-path 1\nat 2e12 0 0 direction 0 1 0", "a.path", "key"))
                .withMessageStartingWith("a.path:2: position x must be from ").withMessageEndingWith(", was 2e12");
    }

    private static void assertRejected(String text, String sentence) {
        String told = assertThrows(IOException.class, () -> MotionPathFile.read(text, "a.path", "key")).getMessage();
        assertThat(told.substring(0, Math.min(told.length(), 1000))).isEqualTo(sentence);
    }

    @ParameterizedTest
    @ValueSource(strings = {"1d", "1f", "0x1p3", "NaN", "Infinity", "1_0", "١", "1e"})
    void numbers_followSceneFileSyntax(String word) {
        assertRejected("lightning-path 1\nat 0 " + word + " 0 direction 0 1 0", "a.path:2: expected a number, found '" + word + "'");
    }

    @ParameterizedTest
    @ValueSource(strings = {"\u2028", "\u0085", "\u3000", "\f", "\u000b", "\r"})
    void onlySpacesTabsAndLineEnds_areSpaces(String space) {
        assertThatIOException()
                .isThrownBy(() -> MotionPathFile.read("lightning-path 1\nat 0 0 0" + space + "direction 0 1 0", "a.path", "key"));
        assertThatIOException().isThrownBy(
                () -> MotionPathFile.read("lightning-path 1\n# one" + space + "at 0 0 0 direction 0 1 0\n", "a.path", "key"))
                .withMessageContaining("at least one key");
    }

    @Test
    void lineOfMegabytes_isQuotedByItsFirstCharacters() {
        assertRejected("lightning-path 1\n" + "a".repeat(30 << 20),
                "a.path:2: expected at x y z direction x y z, found '" + "a".repeat(99) + "…'");
        assertRejected("lightning-path 1\n" + "1 ".repeat(15 << 20),
                "a.path:2: expected at x y z direction x y z, found '" + "1 ".repeat(49) + "1…'");
        assertRejected("lightning-path 1\nat 0 " + "𝟏".repeat(1 << 20) + " 0 direction 0 1 0",
                "a.path:2: expected a number, found '" + "𝟏".repeat(99) + "…'");
    }

    @Test
    void tooLargeFile_isRejected() throws IOException {
        Path file = folder.resolve("large.path");
        try (var sparse = new RandomAccessFile(file.toFile(), "rw")) {
            sparse.setLength((32 << 20) + 1);
        }
        assertThatIOException().isThrownBy(() -> MotionPathFile.load(file, "key"))
                .withMessage(file + ": a motion path may have at most 33554432 bytes");
    }

    @Test
    void endlessDevice_isRejected() {
        Path zeros = Path.of("/dev/zero");
        assumeTrue(Files.exists(zeros));
        assertThatIOException().isThrownBy(() -> MotionPathFile.load(zeros, "key"))
                .withMessage("/dev/zero: is a pipe or a device, expected a motion path");
    }

    @Test
    void byteOrderMark_isSkipped() throws IOException {
        assertThat(MotionPathFile.read("\uFEFFlightning-path 1\nat 0 0 0 direction 0 1 0", "a.path", "key").keyCount()).isEqualTo(1);
    }

    @Test
    void invalidUtf8_isRejected() throws IOException {
        Path file = Files.write(folder.resolve("a.path"), new byte[] {(byte) 0xC3, 0x28});
        assertThatIOException().isThrownBy(() -> MotionPathFile.load(file, "key")).withMessage(file + ": must be UTF-8 text");
    }
}

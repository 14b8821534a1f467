package lightning.format.ies;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import lightning.format.mesh.MeshException;
import lightning.sample.TryFolder;
import lightning.scene.value.Photometry;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** IES files as laboratories write them, and invalid ones. */
class IesReaderTest {
    private static final String PLAIN = "TILT=NONE\n1 1000 1 3 2 1 2 0 0 0\n1 1 20\n0 45 90\n0 90\n100 50 0\n200 100 10\n";

    @TempDir
    private Path folder;

    private Photometry read(String text) throws Exception {
        return read(folder, text);
    }

    private static Photometry read(Path folder, String text) throws Exception {
        return IesReader.read(Files.writeString(folder.resolve("x.ies"), text, StandardCharsets.ISO_8859_1));
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "IESNA91\n[TEST] 1\n[MANUFAC] nobody\n", "IESNA:LM-63-1995\n[TEST]\n", "IESNA:LM-63-2002\r\n[TEST] 1\r\n",
        "IES:LM-63-2019\n[TEST] 1\n[MORE] caf\u00e9\n", "a label\nanother\n"})
    void everyFormatYear_isRead(String header) throws Exception {
        Photometry p = read(header + PLAIN);
        assertThat(p.sample(0, 0)).isEqualTo(0.5);
        assertThat(p.sample(0, 90)).isEqualTo(1);
        assertThat(p.sample(22.5, 45)).isEqualTo((75 + 150) / 2.0 / 200, within(1e-7));
        assertThat(p.sample(90.5, 0)).isZero();
    }

    @Test
    void oneQuadrant_isMirroredToAllFour() throws Exception {
        Photometry p = read(PLAIN);
        for (double angle : new double[] {30, 150, 210, 330}) {
            assertThat(p.sample(45, angle)).isEqualTo(p.sample(45, 30)).isNotZero();
        }
    }

    @Test
    void oneHalf_isMirrored() throws Exception {
        Photometry sides = read("TILT=NONE\n1 1 1 1 3 1 2 0 0 0 1 1 1 0 0 90 180 1 2 4");
        assertThat(sides.sample(0, 225)).isEqualTo(sides.sample(0, 135)).isEqualTo(0.75);
        Photometry ends = read("TILT=NONE\n1 1 1 1 3 1 2 0 0 0 1 1 1 0 90 180 270 1 2 4");
        assertThat(ends.sample(0, 45)).isEqualTo(ends.sample(0, 135)).isEqualTo(0.375);
        assertThat(ends.sample(0, 315)).isEqualTo(ends.sample(0, 225)).isEqualTo(0.75);
        assertThat(ends.sample(0, 0)).isEqualTo(0.5);
    }

    @Test
    void tiltsCommasAndEndOfFileCharacter_areSkipped() throws Exception {
        Photometry p = read("TILT=INCLUDE\n1\n2\n0 90\n1 0.8\n1,1000,1,2,1,1,1,0,0,0\n1 1 1\n0,90\n0\n3,1\n\u001a");
        assertThat(p.sample(45, 200)).isEqualTo(2 / 3.0, within(1e-7));
    }

    @Test
    void typeBFromZero_isMirrored() throws Exception {
        Photometry p = read(PLAIN.replace("3 2 1 2", "3 2 2 2"));
        assertThat(p.type()).isEqualTo(Photometry.Type.B);
        assertThat(p.sample(-45, -45)).isEqualTo(p.sample(45, 45)).isEqualTo(75 / 200.0, within(1e-7));
        assertThat(p.sample(0, 91)).isZero();
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "TILT=NONE | an IES file must have a line that begins with TILT=, found none |",
        "3 2 1 2 | line 2: number of vertical angles must be a number from 1 to 1048576, was '0' | 0 2 1 2",
        "1 3 2 1 2 | line 2: multiplier must be a number from 1e-30 to 1e12, was '0' | 0 3 2 1 2",
        "3 2 1 2 | line 3: expected 3000002 angles and intensities, found 11 | 2 1000000 1 2",
        "3 2 1 2 | line 3: expected 19 angles and intensities, found 11 | 4 3 1 2",
        "3 2 1 2 | line 2: photometric type must be a number from 1 to 3, was '4' | 3 2 4 2",
        "3 2 1 2 | line 2: number of horizontal angles must be a whole number, was 1.5 | 3 1.5 1 2",
        "0 45 90 | line 4: vertical angles must increase, found 45.0 after 90.0 | 0 90 45",
        "0 45 90 | line 4: vertical angle must be a number from 0 to 180, was 'nan' | 0 nan 90",
        "100 50 0 | line 6: intensity must be a number from -1 to 1e12, was '-50' | 100 -50 0",
        "100 50 0 | line 6: intensity must be a number from -1 to 1e12, was '1e999' | 100 1e999 0",
        "0 90 | line 5: horizontal angles must go from 0 to 0, 90, 180 or 360, or from 90 to 270, went from 0.0 to 80.0 | 0 80"})
    void invalidValue_isReportedWithItsLine(String valid, String message, String invalid) {
        String text =
                valid.equals("0 90") ? PLAIN.replace("\n0 90\n", "\n" + invalid + "\n")
                        : PLAIN.replace(valid, invalid == null ? "" : invalid);
        assertThatThrownBy(() -> read(text)).isInstanceOf(MeshException.class)
                .hasMessageEndingWith(message);
    }

    /** Planes of 0 to 270 degrees go on to 360, where the first one is again. */
    @Test
    void missingLastPlane_isTheFirst() throws Exception {
        Photometry p = read("TILT=NONE\n1 1 1 1 4 1 2 0 0 0 1 1 1 0 0 90 180 270 4 3 2 1");
        assertThat(p.sample(0, 315)).isEqualTo(0.625);
        assertThat(p.sample(0, 360)).isEqualTo(1);
    }

    @Test
    void smallFaults_areMended() throws Exception {
        assertThat(read(PLAIN.replace("TILT=NONE", "Tilt = NONE") + "\nEND OF FILE\n").sample(0, 90)).isEqualTo(1);
        assertThat(read(PLAIN.replace("100 50 0", "100 50 -0.01")).sample(90, 0)).isZero();
        assertThat(read(PLAIN.replace("0 45 90", "0 45 45")).sample(45, 0)).isEqualTo(0.25);
    }

    @Test
    void texturesFolder_hasTheGeneratedProfiles() throws Exception {
        assertThat(Path.of("textures/downlight.ies")).hasContent(ProfileMaker.downlight());
        assertThat(Path.of("textures/wall_washer.ies")).hasContent(ProfileMaker.wallWasher());
        assertThat(IesReader.read(Path.of("textures/wall_washer.ies")).sample(30, 0)).isEqualTo(1);
    }

    @Test
    void allZeroIntensities_areRejected() {
        assertThatThrownBy(() -> read(PLAIN.replace("100 50 0\n200 100 10", "0 0 0 0 0 0")))
                .hasMessageEndingWith("one intensity must be above 0, found none");
    }

    @Test
    void tooLargeFile_isRejected() throws Exception {
        Path file = Files.write(folder.resolve("large.ies"), new byte[IesReader.MAX_BYTES + 1]);
        assertThatThrownBy(() -> IesReader.read(file)).hasMessageEndingWith("must have at most 1048576 bytes, has 1048577");
    }

    /** A file with any overwritten byte is read with values from 0 to 1, or rejected with a message. */
    @Property
    void damagedFile_isReadOrReported(@ForAll @IntRange(max = 80) int index, @ForAll @IntRange(max = 255) int newByte,
            @ForAll @IntRange(max = 9) int length)
            throws Exception {
        byte[] bytes = PLAIN.getBytes(StandardCharsets.ISO_8859_1);
        bytes[index % bytes.length] = (byte) newByte;
        try (TryFolder files = new TryFolder()) {
            Path file = Files.write(files.file("damaged.ies"), java.util.Arrays.copyOf(bytes, bytes.length - length));
            Photometry p = IesReader.read(file);
            for (int v = -180; v <= 180; v += 15) {
                for (int h = 0; h <= 360; h += 15) {
                    assertThat(p.sample(v, h)).isBetween(0.0, 1.0);
                }
            }
        } catch (MeshException e) {
            assertThat(e.getMessage()).doesNotContain("\n").contains(":");
        }
    }
}

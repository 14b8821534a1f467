package lightning.format.gltf;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Base64;
import java.util.Random;
import java.util.zip.CRC32;
import lightning.base.work.Progress;
import lightning.format.mesh.ConversionNotes;
import lightning.format.mesh.MeshException;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Data that the library meshoptimizer encoded, against what its own decoder gives: as a checksum or in full. */
class MeshoptCodecTest {
    /** 300 elements of 12 bytes, each a walk of small or large steps. */
    private static final String ATTRIBUTES =
            "oAAAAABVVVVVBKZQSiAERaGWQKYSJhlqopYSUYRioIgWiJZGKSWQglRopKhJgiIQhYBmJlEZFRZQpKYCGVqqSFSZhKBGhRmWFaqqqqoDMVIjNh"
                    + "A2EwNDUwMwJlQFIGUhNTMiYVUURVBUZgBTYkBTMzZmEmMBU2NQMDJCBCAGIFQCViNCFhZkIgEAZgAmAAAGQhQkUGEmYgADVWJhMTUANhMkU0Zh"
                    + "VVBQAhETUkFEA2E2BUZSYDRgU0USMxQyQBUTIxADVRAlUhIAIgZjRaqqqqoHLKffv/+BMBASEA/YDS8a9DXJPw8REQ+PsfeTePhQEA8RENQSmA"
                    + "+vAfHfEBISEmdrENof/8//EhEPDw8Qq/shD/TCMoAQEA8POI+kiB+OHREPD1/7cWZUxPrzDxIREIL8X8SAcK2HEhD29jovCfkH8BISEBAP8/sv"
                    + "UWzDk68SEBIS82UbsflOUE8PDw+WTwosRkFLABD6/b85L1Lc/xESEBIREeCS2BKa71ehEKs2g0D2GnwhEf////8AGS4dTks6Ay4dD0wZKg4yEU"
                    + "cpCzkBEAMYCR8yEjRBJEpGNEQ/OhUpRg0nSEtKL00RMBEcSBIIKkgLQg0jKRkRQDpQOx0TES8GN05JIUNJRSJIIRwbBy4BDEAQKgtISCoUCCsF"
                    + "HEo5GAAVIT8KOhZAAkFAJDtFBEQbMSBQFRgFLggNSQo2GCMuEhcmDi4eATkWSAk6ETcuRwovNQMuKyQlMktJCCAlKgFPR0AdBkgCATg3JBE3DA"
                    + "YjPC4NKgRGAi0HBh0FEEEiFgMFRU1ATCIISQVNEUpJO0AEKDoxACc1GwoBQgkjSi0iDzJMAkUTPjU9SEYfBj45RkIGSC9KHA5K/////wA74GAt"
                    + "ebV+37+zdBA+MTnnhoD5nFrIcauU3IId25NRxvDnwovaFnTY84Ea8LHjB3wXzrzay/XhxJbhgNff5vKaZNKeS9nih6d13oqRq5CligLrso1v0L"
                    + "z8XCw642LFipjZaaLHykLb0nTh2OF0cXHudF/uS8JIqAH4c9Woh1T6sHDQhNePX7YEVn6P6bSZxIjlijd1jsZpCIt+vnQ/v/nS206OzNl+lqfE"
                    + "cmnah3//gANwenM6rKCVZ9azITl93yx8frx324eOfFQAvcjxqqnUe18Mf8bk1pr2d/WaXEavMXh/m/CilvbmwtmffqY/i8Xa2916xf69d8axC5"
                    + "1m/vcAAAAAVVVVVRKSAoGUJpSmRhYlkSGJiGKIkKYiJVBlkGVQUEBRQBZKUChZpWFhFikJVBYaWmRkBWFFEkBSqgREIgQiJSAkUqSqqqqqA2VA"
                    + "IEIUAGJUYwFTAxYxIyJGEVQRUyECZkVhQAYGUwBDQlBEEQZVASM0BjAUYDBCMmElJSQyJRUGBDBhUAETEzQjAAMzQGYWREJiAzJBEhBjVEIkUj"
                    + "VUVDBgQjNFQyZlBRJRNSBBEENkM0JQZjVAFRBDYRJDJAMzAyBgUmNRBROqqqqqCkcg//tpWcYQDxD8RUndv0/2UhIPEhD2bULUdPfsjxIRD6aP"
                    + "YffzNobgEg8Qo4IPpv26NlEREvkBUP8LTw9vEg8QEBERriDdPhRktPoRZKqPr89Bu/gPEBIRr1+6Ja2gLTQSD8Pmndb1BnjiEj34RuZuv6cnDx"
                    + "KfZ+9DAGCvXhEREbifd8BgzwAwDxD/yf4PlbclTxASDxAP32I/XU1DC3cSD5//m9Xnf9i2Eg8REf////8AP0FDPkRBGRsXAQEeIgtIDwobDDk3"
                    + "UBI5Ah4ZESohMQ0nCBQVFiEqBDwnHAEFNC0pCkYRI08nGCsAG0lHSgUfIB0PNC8NAkI/LwYHA0wkOw83LERHDR0YFUQeO0oRE01ASkcfF0kdOR"
                    + "oEPDU0Gw0ELgIXAjkGLTlQLScNM000HDMDDCE2NxQ8IBRBPAMXOwFEExIEQRIZCiA2OC4hHDpQABE1TgsXFjoZFw4YPwE/OCoiRjcsRy4NFh8l"
                    + "Hh0+MUoVKCQ3QkJDISwNIh0fIQAWSQ08DyIVNjonM0oOBBQFIjgGGTwJCiAUBgxFIj9PQREYAA0GMBwYIA4sOBslGCAO/////wCumjftTsGKae"
                    + "3JXQStv3J0w/8jC5z7AOgMapyKppie4tz7dLGYjSvCm3TYa7/93dzXmMPjJUhvv1KxlccDzeNHMSQWYIiw7A6Wj4eXbsnykae1yDCCdrLHpbeF"
                    + "d4qr4vsLV+T53Pzgd5odF53dvm/PoKxwHP6gM8lw+sx1wv6REXBVL0FRpPn6E0cNm+Ssh2/ZgsSH5S7LdauEWuxxxX3lpVv1ztxGyD7GHX3B9n"
                    + "+6+sz/kNjYuXVygiaz177XjB/jeTad3OWLWdLAMcycuhGI7/wH56fQDgJqmLwCzm7Noj3TmnuNmRXU28bgiRp1x0AFCq3km7UYJ3rCpNKOnuAA"
                    + "FVUAUVqFhKpoKGAiACoAEUFSU2NWVkMDVRVENSVjAQJWVWIWAAAq/Fn2zEj+An0PDxD/b5ePilN7LBISDxCrXx8/QNMAABIRED8BFS4pSUQxEz"
                    + "FPPjEuNgE9QykgHiRGEAAHIEQ4PD9FJEhMJUAfLzVBPyQjDQAAAAA/jCripdeohdA13uj453yQdpqS7fPQzZmm83u8DO3Vm34//elzdRqo6WN2"
                    + "caMAAAAAABWlUkgQpEEAGgZWpQAqIVIhEjFWJFQWA1MWFDYTAAYgQmIWIAAAKkqxdzIu+grhEerPL+/v6/nYEBESEhDVJv/8DlgAABARDx8aCy"
                    + "kiBVBQThQgGC5GBh4fIiE0PyMyIxMwTRxPBCAFQr///wARTzsaM0A2L08nMR86wTQb84OGdMcurwLXVuqA26TBEDFnxErl+bMe1Ota3//z/wAc"
                    + "keGsZXDC/c/oUAAAAAAAAAAAAAAAAAAAAAAAAAAAAAED+uGPAP8B+wOu";
    private static final long ATTRIBUTES_SUM = 3762786721L;
    /** A grid of 8 × 8 squares, then 20 random triangles. */
    private static final String TRIANGLES =
            "4f4eEA4QDhAOEA4QDhAOEA7+HhAOEA4QDhAOEA4QDhAO/h4QDhAOEA4QDhAOEA4QDv4eEA4QDhAOEA4QDhAOEA7+HhAOEA4QDhAOEA4QDhAO/h"
                    + "4QDhAOEA4QDhAOEA4QDv4eEA4QDhAOEA4QDhAOEA7+HhAOEA4QDhAOEA4QDhAO//////////////////////////8PEg8CDwIPAg8CDwIPAg8C"
                    + "/3sZA/0mJv83QBX/BiMN/2gUa/4mH/8WH1CEDs9HYP8NhQEUKVZ/LQVPMS7/E3oJ/3NCNi9jHvM4Xc8EIf9wYwL/hAGPASwAdodWZ3iphmWJaJ"
                    + "gBaQAA";
    private static final long TRIANGLES_SUM = 1130270647L;
    private static final int INDEX_COUNT = 444;
    private static final String SEQUENCE =
            "0QAEIB4kAh4EIB4kAh4EIB4kAh4EIB4kAh4EIB4kAh4EIB4kAh4EIB4kAh4EIB4kAhoEIB4kAh4EIB4kAh4EIB4kAh4EIB4kAh4EIB4kAh4EIB"
                    + "4kAh4EIB4kAh4EIB4kAhoEIB4kAh4EIB4kAh4EIB4kAh4EIB4kAh4EIB4kAh4EIB4kAh4EIB4kAh4EIB4kAhoEIB4kAh4EIB4kAh4EIB4kAh4E"
                    + "IB4kAh4EIB4kAh4EIB4kAh4EIB4kAh4EIB4kAhoEIB4kAh4EIB4kAh4EIB4kAh4EIB4kAh4EIB4kAh4EIB4kAh4EIB4kAh4EIB4kAhoEIB4kAh"
                    + "4EIB4kAh4EIB4kAh4EIB4kAh4EIB4kAh4EIB4kAh4EIB4kAh4EIB4kAhoEIB4kAh4EIB4kAh4EIB4kAh4EIB4kAh4EIB4kAh4EIB4kAh4EIB4k"
                    + "Ah4EIB4kAhoEIB4kAh4EIB4kAh4EIB4kAh4EIB4kAh4EIB4kAh4EIB4kAh4EIB4kAh4EIB4kAkkzB01NaYYCVysNRxvMASghTT8TQT8+HAIVGS"
                    + "E0GocBKTYnVgL5AQpiIDwmORMGY20oXB5w1wEcCUsJMhkFRBdZAAAAAA==";
    private static final long SEQUENCE_SUM = 1252221659L;
    private static final String[] OCTAHEDRAL_BYTES =
            {"oAE8AAAA4E0BPAAAADQ4AAE8AAAABAMAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAANkl/fw==", "TGYAf9I9moEAAIF/"};
    private static final String[] OCTAHEDRAL_SHORTS =
            {"oAE8AAAAx+8BPAAAAN5LATwAAAB7MgE8AAAANDgAAAE8AAAABAMBJAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAANs2JEn/f/9/",
                "zExmZgAA/3/r0XA9mpkBgAAAAAABgP9/"};
    private static final String[] QUATERNIONS =
            {"oAE8AAAA/DMBPAAAALMlATwAAAD8aAE8AAAAs0gBPAAAADQsATwAAAAkugEwAAAABgAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAACCWoJaglr8fw==",
                "/z8AQABAAEAAAAAAzExlZjPzmRma2bN2"};
    private static final String[] EXPONENTIAL =
            {"oAEwAAAAEgEwAAAAWgABMAAAACQAATAAAABQASAAAAABMAAAACQBMAAAAAcAAAEwAAAAJAAAAAAAAAAAAAAAAAAAAAAAAAAAABAA9ADY//QEAAD0",
                "AACAPwAAIMAAAIA6ACR0SQAAAAAAAAAA"};

    @TempDir
    private Path folder;

    private static byte[] bytes(String base64) {
        return Base64.getDecoder().decode(base64);
    }

    private static long sum(byte[] data) {
        var sum = new CRC32();
        sum.update(data);
        return sum.getValue();
    }

    private static byte[] bytes(int[] indices) {
        ByteBuffer out = ByteBuffer.allocate(4 * indices.length).order(ByteOrder.LITTLE_ENDIAN);
        out.asIntBuffer().put(indices);
        return out.array();
    }

    @Test
    void attributes_areDecoded() {
        assertThat(sum(MeshoptCodec.attributes(bytes(ATTRIBUTES), 300, 12))).isEqualTo(ATTRIBUTES_SUM);
    }

    @Test
    void triangles_areDecoded() {
        assertThat(sum(bytes(MeshoptCodec.triangles(bytes(TRIANGLES), INDEX_COUNT)))).isEqualTo(TRIANGLES_SUM);
    }

    @Test
    void sequence_isDecoded() {
        assertThat(sum(bytes(MeshoptCodec.indices(bytes(SEQUENCE), INDEX_COUNT)))).isEqualTo(SEQUENCE_SUM);
    }

    @Test
    void filters_areApplied() {
        byte[] octahedral = MeshoptCodec.attributes(bytes(OCTAHEDRAL_BYTES[0]), 3, 4);
        MeshoptCodec.decodeOctahedral(octahedral, 4);
        assertThat(octahedral).isEqualTo(bytes(OCTAHEDRAL_BYTES[1]));
        byte[] shorts = MeshoptCodec.attributes(bytes(OCTAHEDRAL_SHORTS[0]), 3, 8);
        MeshoptCodec.decodeOctahedral(shorts, 8);
        assertThat(shorts).isEqualTo(bytes(OCTAHEDRAL_SHORTS[1]));
        byte[] quaternions = MeshoptCodec.attributes(bytes(QUATERNIONS[0]), 3, 8);
        MeshoptCodec.decodeQuaternion(quaternions);
        assertThat(quaternions).isEqualTo(bytes(QUATERNIONS[1]));
        byte[] floats = MeshoptCodec.attributes(bytes(EXPONENTIAL[0]), 2, 12);
        MeshoptCodec.decodeExponential(floats);
        assertThat(floats).isEqualTo(bytes(EXPONENTIAL[1]));
    }

    private static byte[] file(byte[] data, int count) {
        return GltfFixtures
                .binary("""
                        {'asset': {'version': '2.0'}, 'scenes': [{'nodes': [0]}], 'nodes': [{'mesh': 0}],
                         'extensionsRequired': ['EXT_meshopt_compression'],
                         'meshes': [{'primitives': [{'attributes': {'POSITION': 0}, 'indices': 1}]}],
                         'accessors': [{'bufferView': 1, 'componentType': 5126, 'count': 81, 'type': 'VEC3'},
                          {'bufferView': 0, 'componentType': 5125, 'count': COUNT, 'type': 'SCALAR'}],
                         'bufferViews': [{'buffer': 1, 'byteLength': 0, 'extensions': {'EXT_meshopt_compression': {'buffer': 0, 'byteLength': LENGTH,
                          'byteStride': 4, 'count': COUNT, 'mode': 'TRIANGLES'}}}, {'buffer': 2, 'byteLength': 972}],
                         'buffers': [{'byteLength': LENGTH}, {'byteLength': 0},
                          {'byteLength': 972, 'uri': 'data:application/octet-stream;base64,ZEROS'}]}
                        """
                        .replace("LENGTH", "" + data.length).replace("COUNT", "" + count)
                        .replace("ZEROS", Base64.getEncoder().encodeToString(new byte[972])), data);
    }

    private GltfPart read(byte[] content) throws IOException, MeshException {
        Path file = Files.write(folder.resolve("a.glb"), content);
        return GltfMeshReader.read(GltfFile.read(file, Progress.NONE), new ConversionNotes()).getFirst();
    }

    @Test
    void compressedView_isRead() throws Exception {
        assertThat(read(file(bytes(TRIANGLES), INDEX_COUNT)).triangles().triangleCount()).isEqualTo(INDEX_COUNT / 3);
    }

    @Test
    void wrongCount_isReported() {
        assertThatExceptionOfType(MeshException.class).isThrownBy(() -> read(file(bytes(TRIANGLES), INDEX_COUNT + 300)))
                .withMessageContaining("must be undamaged data of meshoptimizer");
    }

    @Property
    void damagedData_isReadOrReported(@ForAll Random random) {
        byte[] data = bytes(random.nextBoolean() ? TRIANGLES : random.nextBoolean() ? SEQUENCE : ATTRIBUTES);
        for (int i = 0; i <= random.nextInt(4); i++) {
            data[random.nextInt(data.length)] = (byte) random.nextInt();
        }
        try {
            switch (data[0] & 0xF0) {
                case 0xA0 -> MeshoptCodec.attributes(data, 300, 12);
                case 0xD0 -> MeshoptCodec.indices(data, INDEX_COUNT);
                default -> MeshoptCodec.triangles(data, INDEX_COUNT);
            }
        } catch (IllegalArgumentException | IndexOutOfBoundsException e) {
            assertThat(e.getMessage()).isNotEmpty();
        }
    }
}

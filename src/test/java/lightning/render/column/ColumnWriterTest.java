package lightning.render.column;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.lang.foreign.MemorySegment;
import java.nio.ByteBuffer;
import java.nio.channels.Channels;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;

/** Tests that columns are read back as written, or not at all. */
class ColumnWriterTest {
    private static byte[] writeColumns(byte[] bytes, short[] shorts, int[] ints, float[][] floats) throws IOException {
        var out = new ByteArrayOutputStream();
        var writer = new ColumnWriter(Channels.newChannel(out));
        writer.writeArray(bytes);
        writer.writeLong(ints.length);
        writer.writeArray(shorts);
        writer.writeArray(null);
        writer.writeArray(ints);
        writer.writeFloatArrays(floats);
        writer.writeFloatArrays(null);
        writer.writeChecksum();
        return out.toByteArray();
    }

    /** Uses memory without a byte array, as a mapped file. */
    private static ColumnReader reader(byte[] bytes) throws IOException {
        ByteBuffer direct = ByteBuffer.allocateDirect(bytes.length);
        direct.put(bytes).flip();
        return new ColumnReader(MemorySegment.ofBuffer(direct));
    }

    @Property(tries = 50)
    void columns_roundTripBitForBit(@ForAll byte[] bytes, @ForAll short[] shorts, @ForAll int[] ints, @ForAll float[] floats,
            @ForAll @IntRange(max = 200_000) int many) throws IOException {
        float[][] columns = {floats, new float[many]};
        ColumnReader in = reader(writeColumns(bytes, shorts, ints, columns));
        assertThat(in.readArray(ElementType.BYTE)).isEqualTo(bytes);
        assertThat(in.readLong()).isEqualTo(ints.length);
        assertThat(in.readShorts()).isEqualTo(shorts);
        assertThat(in.readOptionalInts()).isNull();
        assertThat(in.readInts()).isEqualTo(ints);
        assertThat(in.readFloatArrays()).isDeepEqualTo(columns);
        assertThat(in.readOptionalFloatArrays()).isNull();
        in.expectEnd();
    }

    @Example
    void missingColumns_areRejected_whereTheyAreNeeded() throws IOException {
        ColumnReader in = reader(writeColumns(new byte[0], new short[0], new int[0], new float[0][]));
        in.readArray(ElementType.BYTE);
        in.readLong();
        in.readShorts();
        assertThatThrownBy(in::readInts).isInstanceOf(IOException.class).hasMessage("expected an array, found none");
        in.readInts();
        in.readFloatArrays();
        assertThatThrownBy(in::readFloatArrays).isInstanceOf(IOException.class).hasMessage("expected columns, found none");
    }

    @Property(tries = 50)
    void anyChangedByte_isDetected(@ForAll byte[] bytes, @ForAll int[] ints, @ForAll int place,
            @ForAll @IntRange(min = 1, max = 255) int by)
            throws IOException {
        byte[] all = writeColumns(bytes, new short[] {1}, ints, new float[][] {{2}});
        all[Math.floorMod(place, all.length)] ^= (byte) by;
        assertThatThrownBy(() -> reader(all)).isInstanceOf(IOException.class);
    }

    @Property(tries = 50)
    void readPastEnd_throwsIoException(@ForAll int[] ints) throws IOException {
        ColumnReader in = reader(writeColumns(new byte[0], new short[0], ints, new float[0][]));
        assertThatThrownBy(() -> {
            while (true) {
                in.readInt();
            }
        }).isInstanceOf(IOException.class);
    }
}

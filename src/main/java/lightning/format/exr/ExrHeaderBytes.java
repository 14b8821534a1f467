package lightning.format.exr;

import java.io.EOFException;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;

/**
 * Start of a file, as far as it was read. Each method throws an {@link EOFException} if the bytes end before the value.
 *
 * @param in little-endian
 */
record ExrHeaderBytes(ByteBuffer in) {
    int position() {
        return in.position();
    }

    void moveTo(int position) {
        in.position(position);
    }

    /** Checks that so many bytes follow. */
    void require(int bytes) throws EOFException {
        if (in.remaining() < bytes) {
            throw new EOFException("is truncated: its OpenEXR header does not end");
        }
    }

    int getInt() throws EOFException {
        require(Integer.BYTES);
        return in.getInt();
    }

    float getFloat() throws EOFException {
        require(Float.BYTES);
        return in.getFloat();
    }

    byte getByte() throws EOFException {
        require(1);
        return in.get();
    }

    byte[] getBytes(int count) throws EOFException {
        require(count);
        byte[] bytes = new byte[count];
        in.get(bytes);
        return bytes;
    }

    /** Returns the next byte without moving. */
    byte peek() throws EOFException {
        require(1);
        return in.get(in.position());
    }

    /**
     * Returns a text that ends with a zero.
     *
     * @throws IOException if it is longer than a name may be
     */
    String readText() throws IOException {
        int start = in.position();
        int length = 0;
        while (getByte() != 0) {
            length++;
            if (length > ExrChannel.MAX_NAME_LENGTH) {
                throw new IOException("has a damaged OpenEXR header: a name is longer than " + ExrChannel.MAX_NAME_LENGTH + " bytes");
            }
        }
        byte[] bytes = new byte[length];
        in.get(start, bytes);
        return new String(bytes, StandardCharsets.ISO_8859_1);
    }
}

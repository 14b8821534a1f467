package lightning.format.exr;

import java.util.List;

/**
 * Layout of the uncompressed pixels of a chunk: line after line, each with all values of the first channel, then those of the next.
 *
 * @param channels in the order of the file
 */
record ExrBlock(List<ExrChannel> channels, int width, int height) {
    /** Returns the bytes per line. */
    long bytesPerLine() {
        return channels.stream().mapToLong(c -> (long) c.type().bytes() * width).sum();
    }

    /** Returns the number of bytes. */
    long byteCount() {
        return bytesPerLine() * height;
    }

    /** Returns the byte offset of each channel within a line. */
    int[] channelOffsets() {
        int[] starts = new int[channels.size()];
        for (int c = 1; c < starts.length; c++) {
            starts[c] = starts[c - 1] + channels.get(c - 1).type().bytes() * width;
        }
        return starts;
    }
}

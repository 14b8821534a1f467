package lightning.format.image;

/**
 * Scans of a JPEG file: passes over the image, each of which adds detail. A file may have thousands of a few bytes each, and decoders
 * visit all pixels in each of them.
 */
final class JpegScans {
    private static final int MAX_SCANS = 200;
    private static final long MAX_VISITED_PIXELS = 1L << 30;

    private static final int MARKER = 0xFF;
    private static final int TEM = 0x01;
    private static final int RST0 = 0xD0;
    private static final int SOI = 0xD8;
    private static final int EOI = 0xD9;
    private static final int SOS = 0xDA;

    private JpegScans() {}

    /** Returns how many scans an image may have. Usual files have at most 20, so that only very large images have too many. */
    static long limit(long pixels) {
        return Math.clamp(MAX_VISITED_PIXELS / pixels, 1, MAX_SCANS);
    }

    /** Returns the number of scans, at least as many as a decoder finds; 0 if the file is not a JPEG. */
    static int count(byte[] file) {
        int scans = 0;
        int at = isJpeg(file) ? 2 : file.length;
        while (at + 1 < file.length) {
            int code = Byte.toUnsignedInt(file[at + 1]);
            if (Byte.toUnsignedInt(file[at]) != MARKER || code == 0 || code == MARKER) {
                // Data of a scan, and bytes that decoders skip.
                at++;
            } else if (code == EOI) {
                return scans;
            } else if (code == TEM || code >= RST0 && code <= SOI) {
                at += 2;
            } else {
                scans += code == SOS ? 1 : 0;
                at += 2 + segmentLength(file, at + 2);
            }
        }
        return scans;
    }

    private static boolean isJpeg(byte[] file) {
        return file.length > 2 && Byte.toUnsignedInt(file[0]) == MARKER && Byte.toUnsignedInt(file[1]) == SOI;
    }

    private static int segmentLength(byte[] file, int at) {
        return at + 1 < file.length ? Byte.toUnsignedInt(file[at]) << 8 | Byte.toUnsignedInt(file[at + 1]) : 0;
    }
}

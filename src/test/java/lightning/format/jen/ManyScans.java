package lightning.format.jen;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Arrays;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageWriteParam;

/** JPEG files that repeat their last scan. */
public final class ManyScans {
    private static final byte SOS = (byte) 0xDA;

    private ManyScans() {}

    /** Returns a progressive JPEG of one gray, about 10 scans and further ones of a few bytes each. */
    public static byte[] jpeg(int width, int height, int furtherScans) throws IOException {
        var out = new ByteArrayOutputStream();
        var writer = ImageIO.getImageWritersByFormatName("jpeg").next();
        ImageWriteParam progressive = writer.getDefaultWriteParam();
        progressive.setProgressiveMode(ImageWriteParam.MODE_DEFAULT);
        try (var stream = ImageIO.createImageOutputStream(out)) {
            writer.setOutput(stream);
            writer.write(null, new IIOImage(new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB), null, null), progressive);
        } finally {
            writer.dispose();
        }
        byte[] file = out.toByteArray();
        int end = file.length - 2;
        int last = end;
        while (file[last] != (byte) 0xFF || file[last + 1] != SOS) {
            last--;
        }
        byte[] scan = Arrays.copyOfRange(file, last, end);
        var all = new ByteArrayOutputStream();
        all.write(file, 0, end);
        for (int i = 0; i < furtherScans; i++) {
            all.writeBytes(scan);
        }
        all.write(file, end, 2);
        return all.toByteArray();
    }

    static byte[] concat(byte[]... parts) {
        var all = new ByteArrayOutputStream();
        Arrays.stream(parts).forEach(all::writeBytes);
        return all.toByteArray();
    }
}

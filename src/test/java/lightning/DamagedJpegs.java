package lightning;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Arrays;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.MemoryCacheImageInputStream;

/** Program that decodes a JPEG without its end many times, while another thread fills the memory. */
final class DamagedJpegs {
    private static final int COUNT = 20_000;

    /** Keeps the compiler from removing the allocations. */
    static volatile byte[] sink;

    private DamagedJpegs() {}

    public static void main(String[] args) throws IOException {
        var image = new BufferedImage(16, 16, BufferedImage.TYPE_INT_RGB);
        for (int i = 0; i < 256; i++) {
            image.setRGB(i % 16, i / 16, i * 7919);
        }
        var out = new ByteArrayOutputStream();
        ImageIO.write(image, "jpeg", out);
        byte[] damaged = Arrays.copyOf(out.toByteArray(), out.size() - 40);
        Thread.ofPlatform().daemon().start(() -> {
            while (true) {
                sink = new byte[1000];
            }
        });
        for (int i = 0; i < COUNT; i++) {
            ImageReader reader = ImageIO.getImageReadersByFormatName("jpeg").next();
            reader.setInput(new MemoryCacheImageInputStream(new ByteArrayInputStream(damaged)), true, true);
            reader.read(0);
            reader.dispose();
        }
    }
}

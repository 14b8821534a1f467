package lightning.format.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIOException;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Base64;
import java.util.List;
import java.util.concurrent.TimeUnit;
import javax.imageio.ImageIO;
import lightning.base.work.HeapBudget;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** WebP files that claim more pixels than they have. */
public class WebpSizeTest {
    /** One color at the lowest quality, 512 × 512 pixels, by libwebp: close to the shortest file of this size. */
    private static final String ONE_COLOR =
            "UklGRjYCAABXRUJQVlA4ICoCAADwOgCdASoAAgACP/3+/3+/uzayIAgD8D+JaW7hd2EffwAAnsA99snIe+2TkPfbJyHwfcwB77ZOQ99snIe+2TplgWS7Xi5"
                    + "OQ99snIe+2TplgWS7Xi5OQ99snIe+4AJiIuTkPfbJyHvtk5D8EpdpUCyXa8XJyHvtk5D32ych77ZOQ99snIe+2TkPfbJyHvtk5D32ych77"
                    + "ZOQ99snIe+2TkPfbJyHvtk5D32ych77ZOQ99snIe+2TkPfbJyHvtk5D32ych77ZOQ99snIe+2Yy09snIe+2TkPfbJyHwH6Xa8XJyHvtk5"
                    + "D32ych77ZOQ99snIe+2TkPfbJyHvtk5D32ych77ZOQ9+AIB77ZOQ99snIe+2Yy09snIe+2TkPfbJyHvtk5D32ych77ZOQ99snIe+2TkPf"
                    + "bJyHvtk5D32ych77ZOQ99snIe+2TkPfbJyHvtk5D32ych77ZOQ9+AIB77ZOQ99snIfQvpdsU2S7Xi5OQ99snIe+2TnERcnIe+2TkPfbJy"
                    + "Hvtk5D32ych77ZOQ99snIe+2TkPfbJyHvtk5D32ych77ZOQ99snIe+2TkPfbJyHvtk5D32yc4iLk5D32ych77ZOQ99snIe+2TkPfbJyHv"
                    + "tk5D32ych77ZOQ99snIesAA/v819/QjHb/61+EPTGHr8YjHwbW3t4MqwtX/RBSGPBH71zMFk78CAAAAGaFAAAAANcKy4EAAADJCsu1YED"
                    + "CgQArSrgzoEAAAAA==";

    public static byte[] oneColor() {
        return Base64.getDecoder().decode(ONE_COLOR);
    }

    private static byte[] toPng(byte[] file) throws IOException {
        return ImageFile.toPng("image", file, new ImageLimits("image", List.of(ImageFormat.WEBP), 1 << 20, 1 << 14, 1 << 28), 1 << 24);
    }

    private static byte[] lossy(int width, int height, int length) {
        ByteBuffer out = ByteBuffer.allocate(length).order(ByteOrder.LITTLE_ENDIAN);
        out.put("RIFF".getBytes(StandardCharsets.US_ASCII)).putInt(length - 8).put("WEBPVP8 ".getBytes(StandardCharsets.US_ASCII))
                .putInt(length - 20).put(new byte[] {16, 0, 0, (byte) 0x9d, 1, 0x2a}).putShort((short) width).putShort((short) height);
        return out.array();
    }

    private static byte[] lossless(int width, int height) {
        return ByteBuffer.allocate(60).order(ByteOrder.LITTLE_ENDIAN).put("RIFF".getBytes(StandardCharsets.US_ASCII)).putInt(52)
                .put("WEBPVP8L".getBytes(StandardCharsets.US_ASCII)).putInt(40).put((byte) 0x2f).putInt(width - 1 | height - 1 << 14)
                .array();
    }

    @Test
    void shortestFile_isDecoded() throws Exception {
        byte[] png = toPng(oneColor());
        assertThat(ImageIO.read(new ByteArrayInputStream(png)).getWidth()).isEqualTo(512);
    }

    @Test
    void fewerThanThreeBitsPerBlock_areImplausible() {
        assertThat(WebpSize.isPlausible(lossy(512, 512, 384))).isTrue();
        assertThat(WebpSize.isPlausible(lossy(512, 512, 383))).isFalse();
    }

    @Test
    @Timeout(value = 5, unit = TimeUnit.SECONDS)
    void largestSizeInAFewBytes_isRejectedAtOnce() {
        assertThatIOException().isThrownBy(() -> toPng(lossy(16383, 16383, 300)));
        byte[] inAnotherFrame = lossy(16, 16, 300);
        System.arraycopy(lossy(16383, 16383, 60), 12, inAnotherFrame, 100, 40);
        assertThatIOException().isThrownBy(() -> toPng(inAnotherFrame));
    }

    @Test
    void moreThanTheMemory_isImplausible() {
        long pixels = HeapBudget.availableBytes() / 5;
        int side = (int) Math.min(16384, Math.sqrt(pixels) + 1);
        assertThat(WebpSize.isPlausible(lossless(side, side))).isEqualTo((long) side * side <= pixels);
        assertThat(WebpSize.isPlausible(lossless(100, 100))).isTrue();
    }
}

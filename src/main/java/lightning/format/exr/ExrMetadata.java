package lightning.format.exr;

import java.util.LinkedHashMap;
import java.util.Map;
import lightning.base.text.ReleaseInfo;

/** Attributes of every written file. */
public final class ExrMetadata {
    private ExrMetadata() {}

    /** Returns the program and its working color space. */
    public static Map<String, ExrAttribute> common() {
        Map<String, ExrAttribute> attributes = new LinkedHashMap<>();
        attributes.put("software", new ExrAttribute.Text(ReleaseInfo.text()));
        attributes.put("chromaticities", ExrAttribute.Chromaticities.REC_709);
        return attributes;
    }
}

package lightning.bench.result;

import lightning.format.pov.PovSampling;
import lightning.scene.AntialiasMode;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;

/** Anti-aliasing of the modern scenes, with the nearest settings of POV-Ray. Its names are part of result files. */
public enum ModernSampling {
    /** One sample per pixel. */
    NONE("none", new SamplingSettings(AntialiasMode.OFF, SamplingSettings.DEFAULT.grid()), PovSampling.NONE),
    /** 4×4 samples in pixels at edges. POV-Ray divides a pixel up to three times, into at most 8×8 parts. */
    EDGES("edges 4×4", new SamplingSettings(AntialiasMode.EDGES, 4), PovSampling.adaptive(0.1, 3));

    private final String label;
    private final SamplingSettings settings;
    private final PovSampling povRay;

    ModernSampling(String label, SamplingSettings settings, PovSampling povRay) {
        this.label = label;
        this.settings = settings;
        this.povRay = povRay;
    }

    /** Returns a short label for tables. */
    public String label() {
        return label;
    }

    /** Returns a label of POV-Ray's nearest settings. */
    public String povRayLabel() {
        return povRay.label();
    }

    public PovSampling povRay() {
        return povRay;
    }

    public SamplingSettings settings() {
        return settings;
    }

    public Scene of(Scene scene) {
        return scene.withPicture(scene.picture().withSampling(settings));
    }
}

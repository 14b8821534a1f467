package lightning.scene.asset;

import lightning.scene.value.Photometry;

/**
 * Measured light distribution from an IES file.
 *
 * @param file       name as written in the scene file
 * @param photometry the decoded data
 */
public record IesProfile(String file, Photometry photometry) implements FileAsset {
    @Override
    public Photometry content() {
        return photometry;
    }
}

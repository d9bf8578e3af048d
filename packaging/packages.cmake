# What CPack makes a Debian package of; packaging/build.sh says for which system and by whom.
set(CPACK_PACKAGE_NAME wold)
set(CPACK_PACKAGE_VENDOR Wold)
set(CPACK_PACKAGE_CONTACT "Wold <unknown>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "natural landscapes that change over time, for Blender and POV-Ray")
set(CPACK_PACKAGE_DESCRIPTION "\
Wold turns one scene file into a landscape that changes over time: grass that\n\
withers by losing water, strength and chlorophyll, clouds that gather, drift\n\
and part, snow that falls, settles and melts, on hillsides of its own or on an\n\
elevation model, under the sun of place and date.\n\
.\n\
It writes scenes for Blender (OpenVDB) and POV-Ray (df3) that show the same\n\
picture, runs these renderers, checks what they make, and encodes films. The\n\
same scene gives the same bytes on every machine.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE
  GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_GENERATOR DEB)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/debian_files.cmake)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Wold itself runs without them, but without a renderer there is no picture.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "blender, povray, ffmpeg, fonts-dejavu-core")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "python3, slurm-client")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
include(CPack)

# Run by CPack on what it has installed, before that is packed: what Debian's policy asks of files
# that other packages do without. Pages of the manual are compressed, the changelog says what is
# packed, and the licences stand in one file.
set(share ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/usr/share)
set(documents ${share}/doc/wold)
if(CPACK_DEBIAN_PACKAGE_RELEASE)
  set(version ${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})
else()
  set(version ${CPACK_PACKAGE_VERSION})
endif()
file(STRINGS ${share}/wold/revision revision)
# So that the same commit gives the same package: SOURCE_DATE_EPOCH is kept to.
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
file(CONFIGURE OUTPUT ${documents}/changelog.Debian CONTENT "wold (${version}) unstable; urgency=medium

  * Built from revision ${revision}. What is new stands in CHANGELOG.md.

 -- ${CPACK_PACKAGE_CONTACT}  ${date}
")
file(RENAME ${documents}/CHANGELOG.md ${documents}/changelog)
file(GLOB pages ${share}/man/man1/*.1)
execute_process(COMMAND gzip -9n ${pages} ${documents}/changelog ${documents}/changelog.Debian
  COMMAND_ERROR_IS_FATAL ANY)
file(COPY ${CMAKE_CURRENT_LIST_DIR}/copyright DESTINATION ${documents})
file(REMOVE ${documents}/LICENSE)  # Debian has it in /usr/share/common-licenses
# Where Debian's zsh looks.
file(RENAME ${share}/zsh/site-functions ${share}/zsh/vendor-completions)
